// SPDX-License-Identifier: GPL-3.0-or-later
// Whether the ground hides a point that may be anywhere.
#pragma once

#include "dem/surface.hpp"
#include "reference/sight_segment.hpp"
#include "view/view.hpp"

#include <vector>

namespace orograph {

/// Of one kind of thing that hides.
struct Verdict {
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
  Verdict ask(ProfilePoint p, long double margin_m) const;

  /// The greatest coordinate.
  double reach_m() const { return reach_m_; }

private:
  View view_;
  std::vector<LongTriangle> triangles_;
  double reach_m_ = 0;
};

} // namespace orograph
