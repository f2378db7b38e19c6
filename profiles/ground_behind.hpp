// SPDX-License-Identifier: GPL-3.0-or-later
// How far the ground falls back behind a silhouette.
#pragma once

#include "dem/surface.hpp"
#include "geometry/profile_point.hpp"
#include "profiles/slab_lines.hpp"
#include "profiles/tin_places.hpp"
#include "profiles/triangles.hpp"
#include "view/view.hpp"

#include <memory>

namespace orograph {

/// Answers for one surface and one view.
class GroundBehind {
public:
  /// REQUIRES that both outlive this. Of a TIN its `tin_places`, which are found if they aren't
  /// given.
  GroundBehind(const Surface& surface, const View& view,
               std::shared_ptr<const TinPlaces> of_tin = nullptr);

  /// Whether, walking on from a point of an edge along its ray, the surface comes up to the ray
  /// again within `reach_m` of depth. Where the terrain ends or has a hole it doesn't. Exact: the
  /// surface is looked at wherever the ray passes an edge. Cost O(triangles passed).
  bool rises_within(SurfaceEdge edge, ProfilePoint from, double reach_m) const {
    return meets(1, edge, from, reach_m);
  }
  /// The same of a surface that comes down to the ray again.
  bool falls_within(SurfaceEdge edge, ProfilePoint from, double reach_m) const {
    return meets(-1, edge, from, reach_m);
  }

private:
  class OnPlane;
  bool meets(double upwards, SurfaceEdge edge, ProfilePoint from, double reach_m) const;

  const Surface& surface_;
  const View& view_;
  EdgeEnds ends_;
  std::shared_ptr<const TinPlaces> of_tin_;
  std::shared_ptr<const OnPlane> on_plane_; ///< of a grid there
};

} // namespace orograph
