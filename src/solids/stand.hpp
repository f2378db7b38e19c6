// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solids/scene_file.hpp"
#include "solids/standing_solid.hpp"

namespace orograph {

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
