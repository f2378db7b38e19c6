// SPDX-License-Identifier: GPL-3.0-or-later
// The answer of a ray walk.
#pragma once

#include <limits>

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

} // namespace orograph
