// SPDX-License-Identifier: GPL-3.0-or-later
// The reference for visibility among solids: whether the eye sees a point that may be anywhere,
// past the ground and past solids.
#pragma once

#include "dem/surface.hpp"
#include "geometry/profile_point.hpp"
#include "reference/sight_segment.hpp"
#include "solids/standing_solid.hpp"
#include "view/view.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace orograph {

/// Of one kind of thing that hides.
struct SightAnswer {
  bool hidden = false;
  bool unsure = false; ///< the other answer is within rounding, or what was asked for on top of it

  bool surely_hidden() const { return hidden && !unsure; }
  bool surely_visible() const { return !hidden && !unsure; }
};

/// A point is hidden by the ground where some point of the terrain's surface at the same X of the
/// visibility plane, not nearer than the near plane and not farther than the point, has a greater
/// Y. At the very depth of the point that is ground above it: it is buried. Seen straight down,
/// only ground above it hides it.
///
/// Every triangle of the terrain is cut, without an index. (RayWalk answers for points of the
/// surface: of the ground that leads up to a point it takes where that begins, which isn't enough
/// under the ground.)
class GroundSight {
public:
  GroundSight(const Surface& surface, const View& view);

  /// REQUIRES p.v > 0 in perspective. A point on the surface itself is always unsure. Cost: one
  /// pass over the triangles.
  SightAnswer ask(ProfilePoint p, long double margin_m) const;

  /// The greatest coordinate.
  double reach_m() const { return reach_m_; }

private:
  View view_;
  std::vector<LongTriangle> triangles_;
  double reach_m_ = 0;
};

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
  SightAnswer ask(ProfilePoint p, long double margin_m, const Own& own) const;

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

/// Asks every triangle of the terrain (GroundSight) and of the solids (SolidSight): no horizon, no
/// intervals, no culling. It shares nothing with what it checks but the vertices' places in the
/// profile frame.
class Sight {
public:
  /// REQUIRES that the solids outlive it, and that a perspective view's eye is in none of them.
  Sight(const Surface& surface, std::span<const StandingSolid> solids, const View& view);

  struct Answer {
    bool by_ground = false, by_solid = false; ///< what hides it; none: it is visible
    /// Whether it is hidden might be otherwise, if the point were moved by its rounding and the
    /// slack.
    bool unsure = false;

    bool hidden() const { return by_ground || by_solid; }
  };

  /// On the ground, above or below it, on a solid or in it. REQUIRES p.v > 0 in perspective. Cost:
  /// one pass over all triangles, and a second one over those near the ray where that is close.
  Answer ask(ProfilePoint p, double slack_m = 0, const Own& own = {}) const;

  /// Of each alone. A point of the surface is always unsure to the ground.
  SightAnswer by_ground(ProfilePoint p, double slack_m = 0) const;
  /// REQUIRES nothing of p.v.
  SightAnswer by_solids(ProfilePoint p, double slack_m = 0, const Own& own = {}) const;

private:
  long double margin_m(ProfilePoint p, double slack_m) const;

  GroundSight ground_;
  SolidSight solids_;
  double reach_m_ = 0;
};

} // namespace orograph
