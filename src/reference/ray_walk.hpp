// SPDX-License-Identifier: GPL-3.0-or-later
// The reference for visibility: what stands between the eye and a ground point
// (docs/how-it-works.md).
#pragma once

#include "dem/grid.hpp"
#include "dem/mesh/tin_index.hpp"
#include "dem/surface.hpp"
#include "dem/tin.hpp"
#include "geometry/box.hpp"
#include "geometry/profile_point.hpp"
#include "view/view.hpp"

#include <cstdint>
#include <limits>
#include <memory>
#include <variant>
#include <vector>

namespace orograph {

/// What stands in front of a ground point: the surface at the point's X of the visibility plane
/// that is strictly nearer. The piece of it that leads up to the point counts where it begins; it
/// ends at the point. (Where it leads up to a place above the point, over a wall, it counts there.)
struct InFront {
  double greatest_y = -std::numeric_limits<double>::infinity(); ///< -infinity: nothing is in front
  double at_depth_m = 0; ///< of the place with the greatest Y
  /// The same of what is nearer by more than a ground position's rounding, or leads up to a place
  /// above: for a point on an edge, which is never in front of itself.
  double greatest_y_apart = -std::numeric_limits<double>::infinity();
  double rounding_m = 0; ///< of positions on the ground: what is no farther aside is met
  double rounding = 0;   ///< bound on the rounding of greatest_y less the point's own Y
};

/// A `RayWalk` whose points cost O(columns + rows), without allocation.
/// REQUIRES a grid on a map plane.
class GridRayWalk {
public:
  GridRayWalk(const Grid& grid, const View& view);
  void set_view(const View& view) { view_ = view; }
  InFront in_front(ProfilePoint p) const;

private:
  const Grid& grid_;
  View view_;
  Vec2 per_column_, per_row_; ///< columns and rows in a ground step of 1 m east, and 1 m north
  double reach_m_ = 0;        ///< bound on the coordinates in the ground frame
  double highest_m_ = 0;      ///< greatest height, or depth below zero
  double steepest_m_ = 0;     ///< greatest difference of height along an edge
};

/// A `RayWalk` that asks every triangle near the ray's ground line. It
/// doesn't follow neighbours, as the cut does: it needs none where the terrain has a hole, and can
/// tell where they are wrong. A point costs O(triangles near the line).
class TinRayWalk {
public:
  TinRayWalk(const Tin& tin, const View& view);
  void set_view(const View& view) { view_ = view; }
  InFront in_front(ProfilePoint p) const;

private:
  const Tin& tin_;
  View view_;
  TinIndex index_;
  double reach_m_ = 0;                      ///< bound on the coordinates in the ground frame
  double highest_m_ = 0;                    ///< greatest height, or depth below zero
  mutable std::vector<std::uint32_t> near_; ///< triangles, reused from point to point
};

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

  /// From now on rays are those of another view of the same surface; what was made of that is kept.
  void set_view(const View& view) {
    std::visit([&](auto& walk) { walk.set_view(view); }, walk_);
  }

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
