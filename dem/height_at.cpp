// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/height_at.hpp"

#include <algorithm>
#include <cmath>

namespace orograph {

std::optional<double> height_at(const Grid& grid, Vec2 ground_m) {
  // Solve ground = first + c * column_step + r * row_step.
  const Vec2 from_first = ground_m - grid.first_vertex_m;
  const double area = cross(grid.column_step_m, grid.row_step_m);
  const double c = cross(from_first, grid.row_step_m) / area;
  const double r = cross(grid.column_step_m, from_first) / area;
  if (!(c >= 0 && r >= 0 && c <= grid.columns - 1 && r <= grid.rows - 1)) return std::nullopt;
  const int column = std::min(static_cast<int>(c), grid.columns - 2);
  const int row = std::min(static_cast<int>(r), grid.rows - 2);
  const double east = c - column, south = r - row;

  const double corner = grid.height_m(column, row), opposite = grid.height_m(column + 1, row + 1);
  const double height = east >= south ? (1 - east) * corner + south * opposite +
                                            (east - south) * grid.height_m(column + 1, row)
                                      : (1 - south) * corner + east * opposite +
                                            (south - east) * grid.height_m(column, row + 1);
  if (std::isnan(height)) return std::nullopt;
  return height;
}

} // namespace orograph
