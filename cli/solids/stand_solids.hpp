// SPDX-License-Identifier: GPL-3.0-or-later
// From a scene file to solids on the ground.
#pragma once

#include "dem/terrain.hpp"
#include "solids/scene_file.hpp"
#include "solids/standing_solid.hpp"

#include <vector>

namespace orograph {

/// The instances of a scene in the ground frame of a terrain, in their order. A place's own frame
/// points east, north and up there; on the ellipsoid along its normal at the place, and heights
/// times the frame's exaggeration. Without ground (see `has_ground`) places are in the coordinates
/// of nothing but the scene. REQUIRES that the scene outlives what comes back.
///
/// Throws Error, with the file and the line, where a place is outside of the terrain or in a gap
/// and has no height of its own, and where longitude and latitude can't be told.
std::vector<StandingSolid> stand_solids(const SceneFile& scene, const Terrain& terrain);

} // namespace orograph
