// SPDX-License-Identifier: GPL-3.0-or-later
// Seeded TINs and views of every awkward kind.
#pragma once

#include "dem/terrain.hpp"
#include "placing/map_spec.hpp"

#include <cstdint>
#include <string>

namespace orograph {

struct RandomTinScene {
  TerrainData terrain;
  MapSpec spec;     ///< a view and a number of profiles; all layers; no files
  std::string what; ///< for messages
};

/// A lattice with holes, islands and walls, points and breaklines that were triangulated, or
/// triangles of very different sizes; seen along the axes, along diagonals or obliquely, from 0 to
/// 90 degrees, with 5 to 40 profiles.
/// With `cracks` parts of walls may be missing, so that ground ends above other ground.
RandomTinScene random_tin_scene(std::uint64_t seed, bool cracks = true);

} // namespace orograph
