/* SPDX-License-Identifier: GPL-3.0-or-later
 * PLplot: plot3d, lines along the grid's rows, hidden lines removed.
 *
 *   plplot DRIVER DEM.heights OUTPUT ELEVATION_DEG
 *
 * DRIVER is PLplot's device: svg, ps, psc, svgcairo, pscairo, pdf, xfig, mem, null … */
#include <math.h>
#include <plplot.h>
#include <string.h>

#include "heights.h"

int main(int count, char** arguments) {
  if (count != 5) {
    fputs("usage: plplot DRIVER DEM.heights OUTPUT ELEVATION_DEG\n", stderr);
    return 2;
  }
  const struct heights h = read_heights(arguments[2]);
  const double elevation_deg = atof(arguments[4]);
  const double width_m = (h.columns - 1) * h.column_step_m;
  const double length_m = (h.rows - 1) * h.row_step_m;
  const double relief_m = h.highest_m - h.lowest_m;

  PLFLT* const x = malloc((size_t)h.columns * sizeof(PLFLT));
  PLFLT* const y = malloc((size_t)h.rows * sizeof(PLFLT));
  PLFLT** z;
  plAlloc2dGrid(&z, h.columns, h.rows);
  for (int i = 0; i < h.columns; ++i) x[i] = i * h.column_step_m;
  for (int j = 0; j < h.rows; ++j) y[j] = j * h.row_step_m;
  for (int j = 0; j < h.rows; ++j)
    for (int i = 0; i < h.columns; ++i) z[i][j] = h.z_m[(size_t)j * (size_t)h.columns + (size_t)i];

  plsdev(arguments[1]);
  plsfnam(arguments[3]);
  static unsigned char memory[4 * 1100 * 800];
  if (strcmp(arguments[1], "mem") == 0) plsmem(1100, 800, memory);
  plscolbg(255, 255, 255);
  plscol0(1, 0, 0, 0);
  plinit();
  pladv(0);
  plcol0(1);
  plwidth(0.3);
  /* The box seen from the south, to scale: a height takes cos, a way north sin of the elevation. */
  const double to_page = acos(-1.0) / 180;
  const double high_m =
      relief_m * cos(elevation_deg * to_page) + length_m * sin(elevation_deg * to_page);
  plvasp(high_m / width_m);
  plwind(-width_m / 2, width_m / 2, -0.5 * length_m * sin(elevation_deg * to_page),
         high_m - 0.5 * length_m * sin(elevation_deg * to_page));
  plw3d(width_m, length_m, relief_m, x[0], x[h.columns - 1], y[0], y[h.rows - 1], h.lowest_m,
        h.highest_m, elevation_deg, 0);
  plot3d(x, y, (const PLFLT* const*)z, h.columns, h.rows, DRAW_LINEX, 0);
  plend();
  return 0;
}
