// SPDX-License-Identifier: GPL-3.0-or-later
// Made scenes whose grid has holes, and islands in them.
#pragma once

#include "tests/scenes/random_scene.hpp"
#include "tests/support/grid_of.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

namespace orograph {

/// Three of five have a hole of 2 to 5 vertices a side; in some of the largest a cross of ground is
/// left. A grid's first triangle is always there.
inline RandomScene scene_with_voids(std::uint64_t seed, Random& random) {
  RandomScene scene = random_scene(seed, 18);
  Grid& grid = grid_of(scene.terrain);
  const auto heights = std::get<Heights<float>>(grid.heights_m).own();
  if (!random.chance(0.6)) return scene;
  const int column = random.whole(1, grid.columns - 6), row = random.whole(1, grid.rows - 6),
            size = random.whole(2, 5);
  const bool has_island = size == 5 && random.chance(0.7);
  for (int r = row; r < std::min(row + size, grid.rows); ++r)
    for (int c = column; c < std::min(column + size, grid.columns); ++c)
      if (!has_island || r == row || c == column || r == row + 4 || c == column + 4)
        heights[grid.index(c, r)] = std::numeric_limits<float>::quiet_NaN();
  for (const auto& [c, r] : {std::pair{0, 0}, {1, 0}, {1, 1}})
    if (std::isnan(heights[grid.index(c, r)])) heights[grid.index(c, r)] = 100;
  return scene;
}

} // namespace orograph
