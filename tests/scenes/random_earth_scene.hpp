// SPDX-License-Identifier: GPL-3.0-or-later
// Seeded terrains in degrees and views of them of every kind.
#pragma once

#include "tests/scenes/random_scene.hpp"
#include "tests/support/random.hpp"

#include <cstdint>

namespace orograph {

/// Whence a terrain in degrees is seen.
enum class Stand {
  frames_terrain, ///< wherever it is seen whole, in any projection
  on_ground,      ///< at a height above the ground, on a vertex or not
  in_air,         ///< above the terrain or beside it, looking at some of it
  looking_down    ///< with a wide field, mostly in two sectors
};

/// Mountains, plains, islands in a sea; of 10 to `most` vertices a side; in one of three with
/// voids, or islands without a sea; cells of 30 m to 10 km on the earth, or on a planet so small
/// that it bends them; at latitudes from -80 to 80, across 180 degrees as elsewhere. Exaggerated up
/// to 3 times, with refraction or none. The ground frame is still in the middle: `stand_on_earth`
/// puts it in its place.
RandomScene random_earth_scene(std::uint64_t seed, Stand stand, int most = 30);

} // namespace orograph
