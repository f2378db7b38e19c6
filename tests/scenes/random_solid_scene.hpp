// SPDX-License-Identifier: GPL-3.0-or-later
// Seeded solids on seeded terrains.
#pragma once

#include "dem/terrain.hpp"
#include "placing/map_spec.hpp"
#include "solids/standing_solid.hpp"

#include <cstdint>
#include <deque>
#include <string>
#include <vector>

namespace orograph {

/// To be moved, never copied: `standing` points to `solids`.
struct SolidScene {
  TerrainData terrain;
  MapSpec spec; ///< a view that can be placed; no files
  std::deque<Solid> solids;
  std::vector<StandingSolid> standing;
  std::string what; ///< for messages
};

/// 1 to 6 solids, convex and not, of a tenth of a cell to half the terrain: on the ground, partly
/// or wholly buried, afloat, before and behind the highest vertex, near the eye, touching or
/// piercing each other; turned, mirrored, or along the axes with whole coordinates. The eye of a
/// perspective view is in none of them, nor nearer to one than a thousandth of its size.
/// The terrain: a grid of 10 to 16 vertices a side (random_scene.hpp), in one seed of four with the
/// eye on it; a TIN (random_tin_scene.hpp) without cracks; or a lattice of whole coordinates seen
/// along its axes or diagonals.
SolidScene random_solid_scene(std::uint64_t seed);

} // namespace orograph
