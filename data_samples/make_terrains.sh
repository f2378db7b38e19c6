#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# make_terrains.sh MAKE_TERRAINS OUT_DIR [VERTICES]: the made terrains as GeoTIFFs, as they are here.
# MAKE_TERRAINS is the program, build/release/data_samples/make_terrains.
# Needs Debian's gdal-bin and python3-gdal (for gdal_edit.py).
set -eu
program=$1 out=$2
shift 2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"$program" "$folder" "$@"
for grid in "$folder"/*.asc; do
  name=$(basename "$grid" .asc)
  crs=EPSG:32631
  [ "$name" != archipelago ] || crs=EPSG:4326
  gdal_translate -q -of VRT -ot Float32 -a_srs $crs "$grid" "$folder/$name.vrt"
  gdal_edit.py -units m "$folder/$name.vrt"
  gdal_translate -q -co COMPRESS=DEFLATE -co PREDICTOR=3 -co ZLEVEL=9 -co BLOCKYSIZE=301 \
    "$folder/$name.vrt" "$folder/$name.tif"
  mv "$folder/$name.tif" "$out/$name.tif"
done
