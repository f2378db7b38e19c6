// SPDX-License-Identifier: GPL-3.0-or-later
// The depths at which a page may show ground.
#pragma once

#include "profiles/plan.hpp"
#include "view/view.hpp"

namespace orograph {

struct DepthRange {
  double nearest_m, farthest_m; ///< the same, if there is no such depth
};

/// Depths between which ground, no farther from its mean height than its relief, can be in the
/// window: all of the terrain where the window was made for it, and in a single sector of a
/// perspective view what is behind the near plane. By the rays of the window's corners, since depth
/// at a height is greatest and least there.
DepthRange shown_depths(const PlanGround& ground, const View& view);

} // namespace orograph
