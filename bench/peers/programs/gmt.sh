#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# GMT: grdview, the mesh (-Qm) or its rows alone (-Qmx), each cell or row painted over those behind.
#   gmt.sh m|mx DEM.tif OUTPUT.ps ELEVATION_DEG COLUMNS ROWS COLUMN_M ROW_M   (absolute paths)
set -euo pipefail
lines=$1 dem=$2 output=$3 elevation=$4 columns=$5 rows=$6 column_m=$7 row_m=$8
read -r length per_m < <(awk -v c="$columns" -v r="$rows" -v cm="$column_m" -v rm="$row_m" \
  'BEGIN { print 20 * r * rm / (c * cm), 20 / (c * cm) }')
cd "$(dirname "$output")" # where it leaves its gmt.history
exec gmt grdview "$dem" -JX20c/"${length}c" -Jz"${per_m}c" -p180/"$elevation" -Q"$lines" -Wm0.1p \
  --PS_MEDIA=a2 >"$output"
