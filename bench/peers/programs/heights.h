/* SPDX-License-Identifier: GPL-3.0-or-later
 * Heights as the peer programs read them: a header of HEIGHTS_HEADER bytes of text, `columns rows
 * column_step_m row_step_m lowest_m highest_m`, then float32 of this machine's byte order, rows
 * from the south, columns from the west. C, so that any of them can include it. */
#ifndef OROGRAPH_PEERS_HEIGHTS_H
#define OROGRAPH_PEERS_HEIGHTS_H

#include <stdio.h>
#include <stdlib.h>

#define HEIGHTS_HEADER 128

struct heights {
  int columns, rows;
  double column_step_m, row_step_m, lowest_m, highest_m;
  float* z_m; /* rows * columns */
};

/* Ends the program in one line where the file isn't such heights. */
static inline struct heights read_heights(const char* path) {
  struct heights h;
  char header[HEIGHTS_HEADER + 1] = "";
  FILE* file = fopen(path, "rb");
  if (!file || fread(header, 1, HEIGHTS_HEADER, file) != HEIGHTS_HEADER ||
      sscanf(header, "%d %d %lf %lf %lf %lf", &h.columns, &h.rows, &h.column_step_m, &h.row_step_m,
             &h.lowest_m, &h.highest_m) != 6) {
    fprintf(stderr, "error: %s has no heights: make them with write_heights\n", path);
    exit(1);
  }
  const size_t count = (size_t)h.columns * (size_t)h.rows;
  h.z_m = (float*)malloc(count * sizeof(float));
  if (!h.z_m || fread(h.z_m, sizeof(float), count, file) != count) {
    fprintf(stderr, "error: %s is cut short: make it again with write_heights\n", path);
    exit(1);
  }
  fclose(file);
  return h;
}

#endif
