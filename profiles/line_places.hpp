// SPDX-License-Identifier: GPL-3.0-or-later
// Where the rows and columns of a grid's vertices are in the profile frame.
#pragma once

#include "dem/grid.hpp"
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

} // namespace orograph
