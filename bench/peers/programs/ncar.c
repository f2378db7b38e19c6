/* SPDX-License-Identifier: GPL-3.0-or-later
 * NCAR Graphics: srface, lines of constant y, upper side only, hidden lines removed.
 *
 *   ncar DEM.heights OUTPUT.ps|OUTPUT.ncgm ELEVATION_DEG
 *
 * srface is a perspective: the eye is put so far away that it is all but parallel. */
#include <math.h>
#include <string.h>

#include "heights.h"

/* Else its headers declare no parameters, and floats arrive as rubbish. */
#define NeedFuncProto 1
#include <ncarg/gks.h>
#include <ncarg/ncargC.h>

/* The Fortran common block of srface's settings. */
extern struct {
  int ifr, istp, irots, idrx, idry, idrz, iupper, iskirt, ncla;
  float theta, hskirt, chi, clo, cinc;
  int ispval;
} srfip1_;

enum { cgm_workstation = 1, ps_workstation = 20, workstation = 1 };

int main(int count, char** arguments) {
  if (count != 4) {
    fputs("usage: ncar DEM.heights OUTPUT.ps|OUTPUT.ncgm ELEVATION_DEG\n", stderr);
    return 2;
  }
  const struct heights h = read_heights(arguments[1]);
  const double elevation = atof(arguments[3]) * acos(-1.0) / 180;
  float* const x = malloc((size_t)h.columns * sizeof(float));
  float* const y = malloc((size_t)h.rows * sizeof(float));
  int* const scratch = malloc(2 * (size_t)h.columns * (size_t)h.rows * sizeof(int));
  /* About the middle, for its arithmetic is float. */
  const double middle_x = 0.5 * (h.columns - 1), middle_y = 0.5 * (h.rows - 1);
  const double middle_m = 0.5 * (h.lowest_m + h.highest_m);
  for (int i = 0; i < h.columns; ++i) x[i] = (float)((i - middle_x) * h.column_step_m);
  for (int j = 0; j < h.rows; ++j) y[j] = (float)((j - middle_y) * h.row_step_m);
  for (size_t i = 0; i < (size_t)h.columns * (size_t)h.rows; ++i)
    h.z_m[i] = (float)(h.z_m[i] - middle_m);

  const double away_m = 300 * (h.columns * h.column_step_m + h.rows * h.row_step_m);
  float sight[6] = {0, (float)(-away_m * cos(elevation)), (float)(away_m * sin(elevation)), 0, 0,
                    0};

  const size_t length = strlen(arguments[2]);
  const int is_ncgm = length > 5 && strcmp(arguments[2] + length - 5, ".ncgm") == 0;
  setenv(is_ncgm ? "NCARG_GKS_OUTPUT" : "NCARG_GKS_PSOUTPUT", arguments[2], 1);
  gopen_gks("stderr", 0);
  gopen_ws(workstation, NULL, is_ncgm ? cgm_workstation : ps_workstation);
  gactivate_ws(workstation);
  srfip1_.idrx = 0;
  srfip1_.iupper = 1;
  c_srface(x, y, h.z_m, scratch, h.columns, h.columns, h.rows, sight, 0);
  gdeactivate_ws(workstation);
  gclose_ws(workstation);
  gclose_gks();
  return 0;
}
