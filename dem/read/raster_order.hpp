// SPDX-License-Identifier: GPL-3.0-or-later
// Bringing a raster's pixels and lines, whichever way they run, to the order of a Grid.
#pragma once

#include "geometry/box.hpp"
#include "geometry/vec.hpp"

#include <cstddef>
#include <optional>

namespace orograph {

/// A raster's vertices (its cell centres) in map coordinates, counted as the file does.
struct RasterLattice {
  int pixels = 0, lines = 0;
  Vec2 first;      ///< of pixel 0 in line 0
  Vec2 pixel_step; ///< from a pixel to the next in its line
  Vec2 line_step;  ///< from a line to the next

  Vec2 position(double pixel, double line) const {
    return first + pixel * pixel_step + line * line_step;
  }
  /// The other way round: a position counted in pixels (x) and lines (y), not rounded.
  Vec2 index_of(Vec2 position) const {
    const Vec2 from_first = position - first;
    const double area = cross(pixel_step, line_step);
    return {cross(from_first, line_step) / area, cross(pixel_step, from_first) / area};
  }
};

/// The same vertices as a Grid counts them, and where each pixel goes in its heights.
struct GridOrder {
  int columns = 0, rows = 0;
  Vec2 first, column_step, row_step; ///< map coordinates
  bool transposed = false;           ///< the raster's lines are columns
  bool columns_reversed = false, rows_reversed = false;
  std::ptrdiff_t start = 0;                   ///< index of the height of pixel 0 in line 0
  std::ptrdiff_t per_pixel = 0, per_line = 0; ///< what a step in the raster adds to the index
};

/// False where pixels and lines run along one line, don't move or aren't finite: no surface then.
bool spans_a_plane(const RasterLattice& lattice);

/// The right-handed order (rows to the right of columns, seen from above) in which columns run
/// nearest to east and rows nearest to south. At exactly 45 degrees columns run north-east.
/// It depends on the set of vertices only, not on the order in which the file stores them.
/// REQUIRES spans_a_plane.
GridOrder grid_order(const RasterLattice& lattice);

/// A window of a raster: `pixels` by `lines` from (pixel, line).
struct RasterWindow {
  int pixel = 0, line = 0, pixels = 0, lines = 0;

  bool empty() const { return pixels <= 0 || lines <= 0; }
};

/// The vertices as a raster would have them that stores them in the order of a Grid: its pixels
/// are columns, its lines rows.
RasterLattice in_grid_order(const GridOrder& order);

/// Which window of the raster holds `part`, a window of `in_grid_order(order)`.
RasterWindow raster_window(const GridOrder& order, const RasterWindow& part);

/// The order of that window's pixels in an array of rows of `width` heights in which the part's
/// first vertex is at (column, row). Only its counts and indices have a meaning.
GridOrder order_within(const GridOrder& order, const RasterWindow& part, int width, int column,
                       int row);

/// True within the box, its border included, whatever rounding did to either: a millionth of a
/// cell outside still counts.
bool in_box(const RasterLattice& lattice, Vec2 position, const Box2& box);

/// The smallest window that holds every vertex in the box; with pixels or lines 0 if there is none.
/// Unless the raster is rotated or sheared, all of the window's vertices are in the box.
/// REQUIRES spans_a_plane, a box that isn't empty.
RasterWindow window_of(const RasterLattice& lattice, const Box2& box);

/// The window's own lattice.
RasterLattice part_of(const RasterLattice& lattice, const RasterWindow& window);

/// Box of all vertices.
Box2 box_of(const RasterLattice& lattice);

} // namespace orograph
