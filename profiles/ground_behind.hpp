// SPDX-License-Identifier: GPL-3.0-or-later
// How far the ground falls back behind a silhouette.
#pragma once

#include "dem/surface.hpp"
#include "geometry/profile_point.hpp"
#include "profiles/surface_edge.hpp"
#include "view/view.hpp"

#include <cstdint>
#include <variant>
#include <vector>

namespace orograph {

/// Answers for one grid and one view.
class GroundBehindGrid {
public:
  GroundBehindGrid(const Grid& grid, const View& view);
  bool rises_within(SurfaceEdge edge, ProfilePoint from, double reach_m) const;

private:
  const Grid& grid_;
  const View& view_;
  Vec2 per_column_, per_row_; ///< columns and rows in a ground step of 1 m east, and 1 m north
};

/// Answers for one TIN and one view.
class GroundBehindTin {
public:
  GroundBehindTin(const Tin& tin, const View& view);
  bool rises_within(SurfaceEdge edge, ProfilePoint from, double reach_m) const;

private:
  const Tin& tin_;
  const View& view_;
  std::vector<std::uint32_t> begin_, triangles_; ///< at vertex i: [begin_[i], begin_[i + 1])
};

/// Answers for either kind of surface.
class GroundBehind {
public:
  /// REQUIRES that both outlive this. Of a TIN: one pass over the triangles.
  GroundBehind(const Surface& surface, const View& view);

  /// Whether, walking on from a point of an edge along its ray, the surface comes up to the ray
  /// again within `reach_m` of depth. Where the terrain ends or has a hole it doesn't. Exact: the
  /// surface is looked at wherever the ray passes an edge. Cost O(triangles passed).
  bool rises_within(SurfaceEdge edge, ProfilePoint from, double reach_m) const {
    return std::visit([&](const auto& ground) { return ground.rises_within(edge, from, reach_m); },
                      ground_);
  }

private:
  std::variant<GroundBehindGrid, GroundBehindTin> ground_;
};

} // namespace orograph
