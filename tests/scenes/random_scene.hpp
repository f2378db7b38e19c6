// SPDX-License-Identifier: GPL-3.0-or-later
// Seeded terrains and views of every awkward kind.
#pragma once

#include "dem/grid.hpp"
#include "dem/terrain.hpp"
#include "placing/map_spec.hpp"

#include <cstdint>
#include <string>

namespace orograph {

struct RandomScene {
  TerrainData terrain;
  MapSpec spec;     ///< a view and a number of profiles; no files
  std::string what; ///< for messages
};

/// A made terrain of 10 to `most` vertices a side, in one seed of four with holes, with plateaus,
/// in whole metres, or all of that; seen along the grid, along its diagonal or obliquely, from 0 to
/// 90 degrees, in perspective where that can be drawn, with 5 to 40 profiles.
RandomScene random_scene(std::uint64_t seed, int most = 36);

} // namespace orograph
