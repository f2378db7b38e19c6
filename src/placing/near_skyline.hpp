// SPDX-License-Identifier: GPL-3.0-or-later
// An eye that is low over large cells, so that the facets it stands on, or the next, hide the
// world.
#pragma once

#include "placing/ground_ahead.hpp"

#include <optional>

namespace orograph {

/// That most of the skyline over a window's width is ground at the eye's feet, with the world
/// beyond.
struct NearSkyline {
  double within_m = 0;     ///< how near: two cells
  double eye_height_m = 0; ///< of the eye above the ground
  /// The eye's height doubled until most of the skyline is ten cells away: from where it is three
  /// the picture is still of a slope at one's feet. None where two cells of height don't do.
  std::optional<double> clear_of_height_m;
};

/// None where most of the skyline is farther away than two cells, or there is no ground ten cells
/// away that it could hide: the terrain ends there.
std::optional<NearSkyline> near_skyline(const View& view, const std::vector<GroundAhead>& ahead,
                                        double cell_m, double eye_height_m);

} // namespace orograph
