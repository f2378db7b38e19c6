// SPDX-License-Identifier: GPL-3.0-or-later
// Views of made scenes from all sides, eyes under the ground and between as well.
#pragma once

#include "dem/extent.hpp"
#include "placing/map_spec.hpp"
#include "tests/support/grid_of.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace orograph {

/// Seen from below and from above, from outside, between, and under the ground.
inline void look_anywhere(MapSpec& spec, const TerrainData& terrain, Random& random) {
  ViewSpec& view = spec.view;
  const Grid& grid = grid_of(terrain);
  const Angle elevation = Angle::degrees(
      random.pick({-90.0, -60.0, -30.0, -10.0, -3.0, 0.0, 3.0, 10.0, 30.0, 60.0, 90.0}));
  switch (random.whole(0, 3)) {
  case 0:
    view.projection = Projection::orthographic;
    view.from_elevation = elevation;
    return;
  case 1:
    view.projection = random.chance(0.3) ? Projection::oblique : Projection::orthographic;
    view.from_elevation = Angle::degrees(random.between(-90, 90));
    view.oblique = {random.between(0.2, 1.2), Angle::degrees(random.between(20, 160))};
    return;
  case 2:
    view.projection = Projection::perspective;
    view.from_elevation = elevation;
    return;
  default:
    break;
  }
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const float height : std::get<Heights<float>>(grid.heights_m))
    if (!std::isnan(height)) {
      low = std::min<double>(low, height);
      high = std::max<double>(high, height);
    }
  const double cell_m = cell_size_m(grid), relief_m = high - low + cell_m;
  const auto anywhere = [&](double beyond) -> Vec3 {
    const Vec2 at =
        grid.plane().position_m(0, 0) +
        random.between(-beyond, grid.columns - 1 + beyond) * grid.plane().column_step_m +
        random.between(-beyond, grid.rows - 1 + beyond) * grid.plane().row_step_m;
    return {at.x, at.y, random.between(low - relief_m, high + relief_m)};
  };
  view.projection = Projection::perspective;
  view.exaggeration = 1;
  view.field_of_view = Angle::degrees(random.pick({30.0, 60.0, 90.0, 120.0}));
  view.eye_map = anywhere(6);
  view.look_at_map = anywhere(0);
}

} // namespace orograph
