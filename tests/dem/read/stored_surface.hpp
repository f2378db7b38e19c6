// SPDX-License-Identifier: GPL-3.0-or-later
// One surface, stored in every order that a raster can have.
#pragma once

#include "dem/read/raster_order.hpp"
#include "tests/dem/read/raster_file.hpp"

#include <array>
#include <cmath>

namespace orograph {

/// A lattice of 7 columns and 5 rows with a height at each vertex that no other one has.
struct StoredSurface {
  int columns = 7, rows = 5;
  Vec2 first{500005, 4999995}, column_step{10, 0}, row_step{0, -8};

  double height(int column, int row) const { return 100 + 10 * row + column; }
  Vec2 position(int column, int row) const { return first + column * column_step + row * row_step; }
};

inline StoredSurface rotated_surface(double angle_deg) {
  StoredSurface surface;
  const double angle = angle_deg * M_PI / 180, c = std::cos(angle), s = std::sin(angle);
  surface.column_step = {10 * c, 10 * s};
  surface.row_step = {8 * s, -8 * c};
  return surface;
}

/// One of the eight ways in which the same vertices can be stored.
struct Storage {
  bool transposed = false, columns_reversed = false, rows_reversed = false;
};

inline std::array<Storage, 8> all_storages() {
  std::array<Storage, 8> all;
  for (unsigned i = 0; i < 8; ++i) all[i] = {(i & 1) != 0, (i & 2) != 0, (i & 4) != 0};
  return all;
}

inline RasterLattice stored_lattice(const StoredSurface& surface, Storage how) {
  RasterLattice lattice;
  lattice.pixels = how.transposed ? surface.rows : surface.columns;
  lattice.lines = how.transposed ? surface.columns : surface.rows;
  const Vec2 column = (how.columns_reversed ? -1. : 1.) * surface.column_step;
  const Vec2 row = (how.rows_reversed ? -1. : 1.) * surface.row_step;
  lattice.pixel_step = how.transposed ? row : column;
  lattice.line_step = how.transposed ? column : row;
  lattice.first = surface.position(how.columns_reversed ? surface.columns - 1 : 0,
                                   how.rows_reversed ? surface.rows - 1 : 0);
  return lattice;
}

/// As a raster with the surface's heights as raw values.
inline RasterFile stored(const StoredSurface& surface, Storage how) {
  const RasterLattice lattice = stored_lattice(surface, how);
  RasterFile raster = counting_raster(lattice.pixels, lattice.lines);
  const Vec2 p = lattice.pixel_step, l = lattice.line_step;
  const Vec2 corner = lattice.first - 0.5 * p - 0.5 * l;
  raster.geotransform = {corner.x, p.x, l.x, corner.y, p.y, l.y};
  for (int line = 0; line < lattice.lines; ++line)
    for (int pixel = 0; pixel < lattice.pixels; ++pixel) {
      int column = how.transposed ? line : pixel, row = how.transposed ? pixel : line;
      if (how.columns_reversed) column = surface.columns - 1 - column;
      if (how.rows_reversed) row = surface.rows - 1 - row;
      raster.values[static_cast<std::size_t>(line * lattice.pixels + pixel)] =
          surface.height(column, row);
    }
  return raster;
}

} // namespace orograph
