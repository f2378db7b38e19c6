// SPDX-License-Identifier: GPL-3.0-or-later
// How far the ground falls back behind a silhouette.
#pragma once

#include "dem/grid.hpp"
#include "geometry/profile_point.hpp"
#include "view/view.hpp"

namespace orograph {

/// Answers for one grid and one view.
class GroundBehind {
public:
  /// REQUIRES that both outlive this.
  GroundBehind(const Grid& grid, const View& view);

  /// Whether, walking on from a point of the surface along its ray, the surface comes up to the ray
  /// again within `reach_m` of depth. Where the terrain ends or has a hole it doesn't. Exact: the
  /// surface is looked at wherever the ray passes an edge. Cost O(cells passed).
  bool rises_within(ProfilePoint from, double reach_m) const;

private:
  const Grid& grid_;
  const View& view_;
  Vec2 per_column_, per_row_; ///< columns and rows in a ground step of 1 m east, and 1 m north
};

} // namespace orograph
