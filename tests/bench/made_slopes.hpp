// SPDX-License-Identifier: GPL-3.0-or-later
// Ground of one slope, or nearly so.
#pragma once

#include "dem/terrain.hpp"

#include <utility>
#include <vector>

namespace orograph {

/// 2900 m by 2900 m, that rises so much in a metre east and north.
inline TerrainData tilted_plane(Vec2 slope) {
  Grid grid;
  grid.columns = grid.rows = 30;
  grid.plane() = {{0, 2900}, {100, 0}, {0, -100}};
  std::vector<float> heights(grid.size());
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column)
      heights[grid.index(column, row)] =
          static_cast<float>(1000 + dot(slope, grid.plane().position_m(column, row)));
  grid.heights_m = std::move(heights);
  TerrainData terrain;
  terrain.surface = std::move(grid);
  return terrain;
}

/// Ground of 590 m by 590 m rising to the north, with a terrace of 100 m across, from 200 to 300 m
/// north.
inline TerrainData terrace() {
  Grid grid;
  grid.columns = 60;
  grid.rows = 60;
  grid.plane() = {{0, 590}, {10, 0}, {0, -10}};
  std::vector<float> heights(grid.size());
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column)
      heights[grid.index(column, row)] =
          static_cast<float>(300 - 5 * row + (row >= 30 && row < 40 ? 100 : 0));
  grid.heights_m = std::move(heights);
  TerrainData terrain;
  terrain.surface = std::move(grid);
  return terrain;
}

} // namespace orograph
