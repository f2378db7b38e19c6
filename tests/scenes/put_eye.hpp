// SPDX-License-Identifier: GPL-3.0-or-later
// Eyes on a grid.
#pragma once

#include "dem/extent.hpp"
#include "dem/height_at.hpp"
#include "placing/map_spec.hpp"
#include "tests/support/random.hpp"

#include <cmath>

namespace orograph {

/// A view from an eye on the surface or a little above it, at a vertex or anywhere, which looks at
/// another vertex.
inline void put_eye(MapSpec& spec, const Grid& grid, Random& random) {
  const auto anywhere = [&](bool at_vertex) -> Vec3 {
    for (;;) {
      const double column = random.between(1, grid.columns - 2.001);
      const double row = random.between(1, grid.rows - 2.001);
      Vec2 at = grid.plane().position_m(static_cast<int>(column), static_cast<int>(row));
      if (!at_vertex)
        at = at + (column - std::floor(column)) * grid.plane().column_step_m +
             (row - std::floor(row)) * grid.plane().row_step_m;
      if (const auto height = height_at(grid, at)) return {at.x, at.y, *height};
    }
  };
  Vec3 eye = anywhere(random.chance(0.6)), target = anywhere(true);
  while (std::hypot(target.x - eye.x, target.y - eye.y) < 3 * cell_size_m(grid))
    target = anywhere(true);
  eye.z += random.pick({0.0, 0.0, 0.001, 1.7, 200.0});
  target.z =
      eye.z + random.pick({0.0, 0.1, -0.1}) * length(Vec2{target.x - eye.x, target.y - eye.y});
  spec.view.projection = Projection::perspective;
  spec.view.exaggeration = 1;
  spec.view.field_of_view = Angle::degrees(random.pick({30.0, 60.0, 90.0}));
  spec.view.eye_map = eye;
  spec.view.look_at_map = target;
}

} // namespace orograph
