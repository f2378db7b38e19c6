#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# GLE: begin surface, lines across the view only, hidden lines removed.
#   gle.sh DEM.z OUTPUT.eps ELEVATION_DEG COLUMNS ROWS COLUMN_M ROW_M LOWEST_M HIGHEST_M
set -euo pipefail
dem=$1 output=$2 elevation=$3 columns=$4 rows=$5 column_m=$6 row_m=$7 lowest=$8 highest=$9
read -r length height tilt < <(awk -v c="$columns" -v r="$rows" -v cm="$column_m" -v rm="$row_m" \
  -v lo="$lowest" -v hi="$highest" -v e="$elevation" 'BEGIN {
    width = (c - 1) * cm
    print 15 * (r - 1) * rm / width, 15 * (hi - lo) / width, 90 - e }')
# x of its box runs away from the viewer, y across (write_heights).
cat >"$output.gle" <<END
size 27.7 20
begin surface
   size 27.7 20
   data "$dem"
   cube off xlen $length ylen 15 zlen $height
   xaxis off
   yaxis off
   zaxis min $lowest max $highest off
   xlines on
   ylines off
   rotate 0 $tilt 0
   view 0 0 0
   harray 20000
end surface
END
exec gle -d eps -o "$output" "$output.gle"
