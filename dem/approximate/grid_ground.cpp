// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/approximate/grid_ground.hpp"

#include "dem/approximate/grid_cells.hpp"

#include <array>
#include <cmath>
#include <utility>

namespace orograph {
namespace {

// As many triangles as a vertex would have around it in a grid without gaps.
int triangles_possible(const Grid& grid, int column, int row) {
  const int west = column > 0, east = column + 1 < grid.columns;
  const int north = row > 0, south = row + 1 < grid.rows;
  return north * (2 * west + east) + south * (west + 2 * east);
}

} // namespace

GridOutline outline_of(const Grid& grid) {
  GridOutline outline;
  std::visit(
      [&](const auto& heights) {
        CellRow north(grid.columns), south(grid.columns);
        for (int row = 0; row < grid.rows; ++row) {
          find_triangles(grid, heights, row, south);
          for (int column = 0; column < grid.columns; ++column) {
            const auto c = static_cast<std::size_t>(column);
            outline.triangles += south.lower[c] + south.upper[c];
            const int around = triangles_around(c, north, south);
            if (around > 0 && around < triangles_possible(grid, column, row))
              outline.vertices.push_back({column, row});
          }
          std::swap(north, south);
        }
      },
      grid.heights_m);
  return outline;
}

bool has_ground(const Grid& grid, LatticePoint a, LatticePoint b, LatticePoint c) {
  // The grid's triangles around a vertex lie between each two of these directions.
  constexpr std::array<LatticePoint, 7> around{
      {{1, 0}, {1, 1}, {0, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, 0}}};
  const LatticePoint inward{(b.column - a.column) + (c.column - a.column),
                            (b.row - a.row) + (c.row - a.row)};
  const auto there = [&](LatticePoint step) {
    return !std::isnan(grid.height_m(a.column + step.column, a.row + step.row));
  };
  std::size_t i = 0;
  while (twice_area({}, around[i], inward) < 0 || twice_area({}, inward, around[i + 1]) < 0) ++i;
  return there({}) && there(around[i]) && there(around[i + 1]);
}

} // namespace orograph
