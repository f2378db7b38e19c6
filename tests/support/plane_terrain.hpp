// SPDX-License-Identifier: GPL-3.0-or-later
// Terrain on a map plane, by a function.
#pragma once

#include "dem/terrain.hpp"

#include <functional>
#include <utility>
#include <vector>

namespace orograph {

/// Cells of 30 m; `height_m` is asked at steps of 0.02 to the east and to the south, from 0 on. NaN
/// is a void.
inline TerrainData plane_terrain(int columns, int rows,
                                 const std::function<double(double, double)>& height_m) {
  std::vector<float> heights;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column)
      heights.push_back(static_cast<float>(height_m(column * 0.02, row * 0.02)));
  TerrainData terrain;
  terrain.surface = Grid{columns, rows, PlaneLattice{{0, 0}, {30, 0}, {0, -30}},
                         Heights<float>(std::move(heights))};
  return terrain;
}

} // namespace orograph
