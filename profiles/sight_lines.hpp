// SPDX-License-Identifier: GPL-3.0-or-later
// What stands in front of an eye in one direction: a walk over the triangles that the upright plane
// of that direction cuts, from the eye on.
#pragma once

#include "dem/surface.hpp"
#include "geometry/vec.hpp"
#include "profiles/outline.hpp"
#include "profiles/sight_starts.hpp"
#include "view/view.hpp"

#include <limits>
#include <optional>
#include <span>
#include <variant>

namespace orograph {

/// A place of the surface in the upright plane of a direction, as drawn: exaggerated and sunk.
struct SightPlace {
  double distance_m; ///< from the eye, seen from above
  double z_m;
  double rounding_m; ///< bound on that of its height
};

/// What is met in one direction, up to some distance.
struct SightLine {
  /// Where the surface stands highest against the eye: the greatest rise for a metre of distance.
  /// Of several that are as high the farthest. None: there is nothing in front.
  std::optional<SightPlace> highest;
  double slope = -std::numeric_limits<double>::infinity(); ///< of that place, from the eye
  double rounding = 0;                                     ///< bound on that of `slope`
  bool at_border = false;           ///< that place: there is no triangle beyond it
  std::optional<SightPlace> ground; ///< the surface at the distance itself, its top on a wall
};

/// The surface as an eye sees it, direction by direction. It knows nothing of horizons and
/// silhouettes: the section of the surface by the plane of a direction bends, begins and ends at
/// edges, so its greatest slope is at one of them, and it asks each.
class SightLines {
public:
  /// `view` is in perspective; its profile frame is that of directions, and eye, exaggeration and
  /// drop are all that is asked of it. `border` is `border_edges` of the surface. REQUIRES that the
  /// surface outlives this. Cost: O(border), of a TIN one pass over its triangles.
  SightLines(const Surface& surface, std::span<const BorderEdge> border, const View& view);
  SightLines(Surface&&, std::span<const BorderEdge>, const View&) = delete;

  /// Edges nearer than `distance_m` (infinity: all) in a direction, a unit vector along u and v.
  /// Triangles hold their edges: along an edge, or through a vertex, both sides are met. Safe from
  /// several threads. Cost: the triangles that the plane cuts up to there, some 5 ns each.
  SightLine up_to(Vec2 direction, double distance_m) const;
  SightLine skyline(Vec2 direction) const {
    return up_to(direction, std::numeric_limits<double>::infinity());
  }

  /// Of places on the ground: what is no farther aside from an edge is on it.
  double rounding_m() const { return rounding_m_; }

private:
  template <class Take>
  auto with_mesh(const Take& take) const;

  const Surface& surface_;
  View view_;
  double rounding_m_ = 0;
  std::variant<SightStarts<GridSide>, SightStarts<TinSide>> starts_;
};

} // namespace orograph
