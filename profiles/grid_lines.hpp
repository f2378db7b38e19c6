// SPDX-License-Identifier: GPL-3.0-or-later
// The rows and columns of a grid's vertices: where they are in the profile frame, and the profile
// in a plane that holds one of them.
#pragma once

#include "dem/grid.hpp"
#include "profiles/profile.hpp"
#include "profiles/triangles.hpp"
#include "view/view.hpp"

#include <cstddef>
#include <vector>

namespace orograph {

/// Whether rows run along the ground frame's x and columns along its y. There u and v of a vertex
/// are a number of its column and one of its row, added, to the bit.
bool is_upright(const Grid& grid);

/// u and v of a grid's vertices, as a number of the column and one of the row.
struct LinePlaces {
  static constexpr int kBeside = 2; ///< columns and rows that are there on each side of the grid
  std::vector<double> column_u, column_v, row_u, row_v;

  /// REQUIRES `is_upright(grid)`.
  LinePlaces(const Grid& grid, const View& view);

  double u(int column, int row) const {
    return column_u[static_cast<std::size_t>(column + kBeside)] +
           row_u[static_cast<std::size_t>(row + kBeside)];
  }
  double v(int column, int row) const {
    return column_v[static_cast<std::size_t>(column + kBeside)] +
           row_v[static_cast<std::size_t>(row + kBeside)];
  }
};

/// Depths of the grid's rows if the view looks along its columns, of its columns if it looks along
/// its rows, those of the vertices to the bit, rising; none in other views and of turned grids, on
/// the ellipsoid, and where two of them are the same number.
std::vector<double> row_depths(const Grid& grid, const View& view);

/// Adds the profile at `depth_m` to `out`, bit for bit that of `walk_grid`, but for what lies
/// farther than a few vertices outside `range`. False, with nothing added, where the plane doesn't
/// hold a whole row or column. Cost: about 2 ns a vertex of a row, 10 of a column, whose heights
/// are far apart in memory; no allocation once `out` is warm. REQUIRES that `places` are those of
/// the grid in the view, and depth rises or falls from row to row, or from column to column, in
/// floating point as well.
bool cut_row(const Grid& grid, const View& view, const TriangleSet& level, const LinePlaces& places,
             double depth_m, const URange& range, Profile& out);

} // namespace orograph
