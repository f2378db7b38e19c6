// SPDX-License-Identifier: GPL-3.0-or-later
// Seas and lakes: connected triangles of exactly one height.
#pragma once

#include "dem/grid.hpp"
#include "profiles/triangles.hpp"

#include <vector>

namespace orograph {

struct LevelGround {
  TriangleSet triangles;        ///< empty where there is no level ground
  std::vector<GridEdge> shores; ///< edges between level ground and other terrain
  std::size_t regions = 0;
};

/// The level regions of at least `smallest` triangles. Two triangles belong together if they share
/// an edge. Cost: one pass over the heights; memory a bit a triangle and 12 bytes for each run of
/// level triangles along a row.
LevelGround find_level_ground(const Grid& grid, std::size_t smallest);

/// The size from which level ground reads as water on a page rather than as a step of whole-metre
/// heights: 500 triangles, and a five-thousandth of the grid (10 mm² of an A4 map).
std::size_t smallest_water(const Grid& grid);

} // namespace orograph
