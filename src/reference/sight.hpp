// SPDX-License-Identifier: GPL-3.0-or-later
// The reference for visibility among solids: whether the eye sees a point that may be anywhere.
#pragma once

#include "dem/surface.hpp"
#include "geometry/profile_point.hpp"
#include "reference/ground_sight.hpp"
#include "reference/solid_sight.hpp"
#include "solids/standing_solid.hpp"
#include "view/view.hpp"

#include <span>

namespace orograph {

/// Asks every triangle of the terrain (ground_sight.hpp) and of the solids (solid_sight.hpp): no
/// horizon, no intervals, no culling. It shares nothing with what it checks but the vertices'
/// places in the profile frame.
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
  Verdict by_ground(ProfilePoint p, double slack_m = 0) const;
  /// REQUIRES nothing of p.v.
  Verdict by_solids(ProfilePoint p, double slack_m = 0, const Own& own = {}) const;

private:
  long double margin_m(ProfilePoint p, double slack_m) const;

  GroundSight ground_;
  SolidSight solids_;
  double reach_m_ = 0;
};

} // namespace orograph
