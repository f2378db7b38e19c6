// SPDX-License-Identifier: GPL-3.0-or-later
// Between a view in a file and the ground frame.
#pragma once

#include "dem/mesh/half_space.hpp"
#include "dem/terrain.hpp"
#include "placing/view_file.hpp"
#include "view/phigs_view.hpp"
#include "view/view.hpp"

#include <vector>

namespace orograph {

/// The view in the ground frame, heights times `exaggeration`. Planes that the file doesn't give
/// are out of the way of any terrain.
PhigsView phigs_view(const ViewFile& file, const MapFrame& map, double exaggeration);

/// What is between the front and the back plane, as far as the file gives them: in the ground
/// frame, true heights. Empty if it gives none.
std::vector<HalfSpace> between_planes(const ViewFile& file, const MapFrame& map,
                                      double exaggeration);

/// Any view, as a file would give it.
/// Of a perspective view of a terrain in degrees its directions are those of the frame below the
/// eye, wherever the terrain's own frame is.
ViewFile view_file_of(const View& view, const MapFrame& map);

} // namespace orograph
