// SPDX-License-Identifier: GPL-3.0-or-later
// Instances of solids on the ground.
#pragma once

#include "solids/solid.hpp"

#include <cstddef>
#include <vector>

namespace orograph {

struct SceneFile;
struct SolidInstance;

/// REQUIRES that the solid outlives it.
struct StandingSolid {
  const Solid* solid = nullptr;
  std::vector<Vec3> vertices_m; ///< those of the solid in the terrain's ground frame, true heights
  bool mirrored = false;        ///< its triangles run clockwise for who looks from outside
  std::size_t place = 0;        ///< of the scene file, which put it there
};

/// Where a place's own frame is in the ground frame: its origin, and what a metre along its axes
/// is.
struct PlaceFrame {
  Vec3 at_m;
  Vec3 east{1, 0, 0}, north{0, 1, 0}, up{0, 0, 1};
};

/// An instance of one of the scene's solids at its place. REQUIRES that the scene outlives it.
StandingSolid stand_at(const PlaceFrame& place, const SolidInstance& instance,
                       const SceneFile& scene);

} // namespace orograph
