// SPDX-License-Identifier: GPL-3.0-or-later
// The reference for visibility: what stands between the eye and a ground point
// (docs/how-it-works.md).
#pragma once

#include "dem/surface.hpp"
#include "geometry/profile_point.hpp"
#include "reference/grid_ray_walk.hpp"
#include "reference/in_front.hpp"
#include "reference/tin_ray_walk.hpp"
#include "view/view.hpp"

#include <memory>
#include <variant>

namespace orograph {

/// Walks over every edge of the surface that the vertical plane of a point's ray crosses: no
/// horizon, no profiles, no silhouettes. The section of the surface by that plane is greatest where
/// it bends, begins or ends, which is at those edges, or at the near plane in perspective.
class RayWalk {
public:
  /// REQUIRES that the surface outlives the walk. Cost: one pass over it. Of a grid on the
  /// ellipsoid the TIN of its triangles is made, some 50 bytes a triangle.
  RayWalk(const Grid& grid, const View& view);
  RayWalk(const Tin& tin, const View& view);
  RayWalk(const Surface& surface, const View& view);

  /// A point of the surface is hidden if and only if greatest_y is more than its own Y; where the
  /// two differ by no more than `rounding`, double precision can't tell. Triangles hold their
  /// edges: a ray along an edge or through a vertex meets what is there on either side.
  /// REQUIRES p.v > 0 in perspective. Cost: the edges near the ray.
  InFront in_front(ProfilePoint p) const {
    return std::visit([&](const auto& walk) { return walk.in_front(p); }, walk_);
  }

private:
  std::shared_ptr<const Tin> triangles_; ///< of a grid on the ellipsoid; never changes
  std::variant<GridRayWalk, TinRayWalk> walk_;
};

} // namespace orograph
