// SPDX-License-Identifier: GPL-3.0-or-later
// Families of small scenes that are hard for a hidden-line program, each in its own way.
#pragma once

#include "dem/terrain.hpp"
#include "placing/map_spec.hpp"
#include "tests/support/random.hpp"

#include <span>
#include <string>

namespace orograph {

struct HardScene {
  TerrainData terrain; ///< a grid on a map plane, of 3 to 8 vertices a side
  MapSpec spec;
};

struct HardFamily {
  std::string name;
  HardScene (*make)(Random& random);
};

std::span<const HardFamily> hard_families();

} // namespace orograph
