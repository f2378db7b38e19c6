// SPDX-License-Identifier: GPL-3.0-or-later
// An instance of a solid on the ground.
#pragma once

#include "solids/solid.hpp"

#include <cstddef>
#include <vector>

namespace orograph {

/// REQUIRES that the solid outlives it.
struct StandingSolid {
  const Solid* solid = nullptr;
  std::vector<Vec3> vertices_m; ///< those of the solid in the terrain's ground frame, true heights
  bool mirrored = false;        ///< its triangles run clockwise for who looks from outside
  std::size_t place = 0;        ///< of the scene file, which put it there
};

} // namespace orograph
