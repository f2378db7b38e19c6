# SPDX-License-Identifier: GPL-3.0-or-later
# gnuplot: splot with lines and hidden3d, on the grid: lines both ways, for it draws no others.
#   gnuplot -c gnuplot.gp DEM.heights OUTPUT.svg ELEVATION_DEG COLUMNS ROWS COLUMN_M ROW_M
set terminal svg size 2000,1400 background rgb 'white'
set output ARG2
set linetype 1 lc rgb 'black' lw 0.3
set hidden3d nooffset
set view 90 - ARG3, 0, 1, 1
set view equal xyz
unset border
unset tics
unset key
set xyplane 0
splot ARG1 binary skip=128 array=(@ARG4,@ARG5) dx=@ARG6 dy=@ARG7 format='%float' using 1 with lines lt 1
unset output
