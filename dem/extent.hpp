// SPDX-License-Identifier: GPL-3.0-or-later
// Where a grid's heights are, by blocks.
#pragma once

#include "dem/grid.hpp"
#include "geometry/blocked_points.hpp"

namespace orograph {

/// What one pass over the heights tells.
struct GridExtent {
  BlockedPoints blocks; ///< valid vertices (ground position and height, metres); refers to the grid
  Box3 box;             ///< of all valid vertices
  double mean_height_m = 0; ///< of all valid vertices
  std::size_t valid = 0;    ///< vertices that have a height
};

/// REQUIRES at least one valid vertex. One pass, at the speed of memory. Blocks are 32 x 32
/// vertices, so about a thousandth of the heights' memory.
GridExtent extent_of(const Grid& grid);

} // namespace orograph
