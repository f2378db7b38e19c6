// SPDX-License-Identifier: GPL-3.0-or-later
// What a view asks of the solids in it.
#pragma once

#include "cli/view_file.hpp"
#include "dem/terrain.hpp"
#include "solids/scene_file.hpp"
#include "solids/standing_solid.hpp"
#include "view/view.hpp"

#include <vector>

namespace orograph {

/// Leaves out the solids that are cut away: those outside of the front or back plane. Throws Error,
/// with the file and the line, for one that a plane goes through: it would have to be closed there.
void leave_out_cut(std::vector<StandingSolid>& standing, const SceneFile& scene,
                   const ViewFile& view, const MapFrame& map, double exaggeration);

/// Throws Error, with the file and the line, where the eye of a perspective view is inside of a
/// solid.
void check_eye_outside(const std::vector<StandingSolid>& standing, const SceneFile& scene,
                       const View& view);

} // namespace orograph
