// SPDX-License-Identifier: GPL-3.0-or-later
// Solids put in their places on the ground, and what a view asks of them.
#pragma once

#include "dem/terrain.hpp"
#include "placing/view_file.hpp"
#include "solids/scene_file.hpp"
#include "solids/standing_solid.hpp"
#include "view/view.hpp"

#include <vector>

namespace orograph {

/// The instances of a scene in the ground frame of a terrain, in their order. A place's own frame
/// points east, north and up there; on the ellipsoid along its normal at the place, and heights
/// times the frame's exaggeration. Without ground (see `has_ground`) places are in the coordinates
/// of nothing but the scene. REQUIRES that the scene outlives what comes back.
///
/// Throws Error, with the file and the line, where a place is outside of the terrain or in a gap
/// and has no height of its own, and where longitude and latitude can't be told.
std::vector<StandingSolid> stand_solids(const SceneFile& scene, const TerrainData& terrain);

/// Leaves out the solids that are cut away: those outside of the front or back plane. Throws Error,
/// with the file and the line, for one that a plane goes through: it would have to be closed there.
void leave_out_cut(std::vector<StandingSolid>& standing, const SceneFile& scene,
                   const ViewFile& view, const MapFrame& map, double exaggeration);

/// Throws Error, with the file and the line, where the eye of a perspective view is inside of a
/// solid.
void check_eye_outside(const std::vector<StandingSolid>& standing, const SceneFile& scene,
                       const View& view);

} // namespace orograph
