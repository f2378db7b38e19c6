// SPDX-License-Identifier: GPL-3.0-or-later
// The ray walk over a grid.
#pragma once

#include "dem/grid.hpp"
#include "geometry/profile_point.hpp"
#include "reference/in_front.hpp"
#include "view/view.hpp"

namespace orograph {

/// A `RayWalk` (reference/ray_walk.hpp) whose points cost O(columns + rows), without allocation.
/// REQUIRES a grid on a map plane.
class GridRayWalk {
public:
  GridRayWalk(const Grid& grid, const View& view);
  InFront in_front(ProfilePoint p) const;

private:
  const Grid& grid_;
  View view_;
  Vec2 per_column_, per_row_; ///< columns and rows in a ground step of 1 m east, and 1 m north
  double reach_m_ = 0;        ///< bound on the coordinates in the ground frame
  double highest_m_ = 0;      ///< greatest height, or depth below zero
  double steepest_m_ = 0;     ///< greatest difference of height along an edge
};

} // namespace orograph
