// SPDX-License-Identifier: GPL-3.0-or-later
// Whether solids hide a point that may be anywhere.
#pragma once

#include "reference/ground_sight.hpp"
#include "reference/sight_segment.hpp"
#include "solids/standing_solid.hpp"
#include "view/view.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace orograph {

/// What touches a point because the point is on it, and so can't hide it.
struct Own {
  enum class Which {
    all_touching, ///< whatever triangle the point is on
    edge,         ///< the triangles beside an edge of a solid
    none
  } which = Which::all_touching;
  std::size_t solid = 0, edge = 0; ///< by number
};

/// A point is hidden by a solid where the open straight segment from the eye to it (in a parallel
/// view from far away) meets a triangle of the solid, whichever way that faces. As the eye is
/// outside, a point inside is. Every triangle is asked, without an index, in long double.
class SolidSight {
public:
  SolidSight(std::span<const StandingSolid> solids, const View& view);

  /// Unsure where the segment passes a triangle's border or ends near a triangle, within the
  /// margin, and that decides. Where all rays around the segment, moved by the margin and by a
  /// third of it in sixteen directions, meet one and the same solid, it doesn't.
  Verdict ask(ProfilePoint p, long double margin_m, const Own& own) const;

  /// The greatest coordinate.
  double reach_m() const { return reach_m_; }

private:
  struct Face {
    LongTriangle corners;
    LongVec middle;
    long double radius_m;
    std::size_t solid, triangle;
  };
  SightSegment segment_to(LongVec p) const;
  bool is_own(const Face& face, LongVec p, long double margin_m, const Own& own) const;

  View view_;
  std::span<const StandingSolid> solids_;
  std::vector<Face> faces_;
  double reach_m_ = 0;
};

} // namespace orograph
