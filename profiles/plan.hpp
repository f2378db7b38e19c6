// SPDX-License-Identifier: GPL-3.0-or-later
// Where to cut: the depths at which a page may show ground, and those of the profiles.
#pragma once

#include "profiles/plan_request.hpp"
#include "view/view.hpp"

#include <vector>

namespace orograph {

/// What the plan has to know of the ground.
struct PlanGround {
  double nearest_m, farthest_m; ///< depths between which there is terrain
  double mean_z_m;              ///< exaggerated
  double relief_m;              ///< highest less lowest, exaggerated
  /// Of a grid that is seen along its rows or columns: where those that profiles can run along are,
  /// rising. Otherwise empty.
  std::vector<double> row_depths_m = {};
};

struct DepthRange {
  double nearest_m, farthest_m; ///< the same, if there is no such depth
};

/// Depths between which ground, no farther from its mean height than its relief, can be in the
/// window: all of the terrain where the window was made for it, and in a single sector of a
/// perspective view what is behind the near plane. By the rays of the window's corners, since depth
/// at a height is greatest and least there.
DepthRange shown_depths(const PlanGround& ground, const View& view);

/// Depths of the profiles, rising strictly: front to back, none on the terrain's very ends.
///
/// A number of profiles, or a spacing in mm, goes evenly over the page: as far apart as on a plane
/// at the terrain's mean height. Where that plane is seen so flatly that hills and not the ground
/// fill the page (an eye low among them, a parallel view from the side), the plane is lowered, or
/// tilted, to what the relief fills, and a spacing makes no fewer profiles than would go on two
/// thirds of the picture's height. A spacing in metres goes evenly over the ground; if it is a
/// whole number of the grid's rows, profiles are rows.
/// Throws Error where that makes more than 100000 profiles.
std::vector<double> plan_depths(const PlanRequest& request, const PlanGround& ground,
                                const View& view, const Homography& to_page);

} // namespace orograph
