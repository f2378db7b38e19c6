#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# make_volcano.sh OUT.tif: R's `volcano` grid, turned right and put in its place.
# Needs Debian's r-base-core, gdal-bin and python3-gdal (for gdal_edit.py).
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# help(volcano): rows run east to west, columns south to north. So the first row of a map is R's
# last, and each is read backwards.
Rscript -e '
  north_up <- volcano[nrow(volcano):1, ncol(volcano):1]
  writeLines(c("ncols 61", "nrows 87", "xllcorner 2667400", "yllcorner 6478700", "cellsize 10"),
             commandArgs(TRUE)[1])
  write.table(north_up, commandArgs(TRUE)[1], append = TRUE, row.names = FALSE, col.names = FALSE)
' "$folder/volcano.asc"

gdal_translate -q -ot Int16 -a_srs EPSG:27200 -co COMPRESS=DEFLATE -co PREDICTOR=2 -co ZLEVEL=9 \
  -co BLOCKYSIZE=87 "$folder/volcano.asc" "$folder/volcano.tif"
gdal_edit.py -units m "$folder/volcano.tif"
mv "$folder/volcano.tif" "$1"
