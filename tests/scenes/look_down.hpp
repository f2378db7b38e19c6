// SPDX-License-Identifier: GPL-3.0-or-later
// Cameras above a grid.
#pragma once

#include "dem/extent.hpp"
#include "dem/height_at.hpp"
#include "dem/terrain.hpp"
#include "placing/map_spec.hpp"
#include "tests/support/grid_of.hpp"
#include "tests/support/random.hpp"

#include <algorithm>

namespace orograph {

/// From anywhere over the terrain or beside it, low or high, at anything below, with any field.
inline void look_down(MapSpec& spec, const TerrainData& terrain, Random& random) {
  const Box3 box = extent_of(terrain.surface).box;
  const double size = std::max(box.high.x - box.low.x, box.high.y - box.low.y);
  const auto within = [&](double beyond) {
    return Vec2{random.between(box.low.x - beyond * size, box.high.x + beyond * size),
                random.between(box.low.y - beyond * size, box.high.y + beyond * size)};
  };
  Vec2 eye = within(0.1);
  // Exactly over a vertex, a row or a column, as users' coordinates are.
  const Grid& grid = grid_of(terrain);
  if (random.chance(0.4))
    eye =
        grid.plane().position_m(random.whole(0, grid.columns - 1), random.whole(0, grid.rows - 1));
  const double height = box.high.z + random.pick({0.01, 0.2, 1.0}) * size;
  const Vec2 target = random.chance(0.4) ? eye : within(-0.3);
  spec.view.projection = Projection::perspective;
  spec.view.exaggeration = random.pick({1.0, 2.0});
  spec.view.eye_map = Vec3{eye.x, eye.y, height};
  // On the ground itself, or a hair above it.
  if (const auto ground = height_at(grid, eye); ground && random.chance(0.15))
    spec.view.eye_map->z = *ground + random.pick({0.0, 1e-9, 1e-6, 1e-3});
  spec.view.look_at_map = Vec3{target.x, target.y, box.low.z};
  spec.view.from_azimuth = Angle::degrees(random.pick({0.0, 90.0, random.between(0, 360)}));
  spec.view.field_of_view = Angle::degrees(random.pick({30.0, 60.0, 120.0, 170.0}));
  spec.view.roll = Angle::degrees(random.pick({0.0, random.between(-180, 180)}));
}

} // namespace orograph
