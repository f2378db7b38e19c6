// SPDX-License-Identifier: GPL-3.0-or-later
// What of a grid need not be looked at: ground beside the page, and ground wholly under the horizon
// of what stands in front of it.
#pragma once

#include "dem/grid.hpp"
#include "geometry/projected_profile.hpp"
#include "profiles/seen_ground.hpp"
#include "view/view.hpp"

namespace orograph {

struct SeenGroundRequest {
  XRange range;       ///< what is shown; may be infinite
  double tolerance_y; ///< ground less than this under the horizon is looked at
};

/// Blocks of which nothing is in the range, nearer than the view's near plane, or of which all is
/// under the horizon by more than the tolerance are left out; others may be left out or not, but
/// never one with anything to be seen. Nothing that the blocks left out hold hides anything of
/// those looked at.
///
/// The horizon is that of profiles some cells apart, as a lower bound in narrow columns of X: what
/// the surface hides is more. A block's upper bound is its greatest height.
/// REQUIRES a grid on a map plane. The same on any number of cores. Cost: 2 to 3 ns a height.
SeenGround find_seen_ground(const Grid& grid, const View& view, const SeenGroundRequest& request);

} // namespace orograph
