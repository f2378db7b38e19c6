// SPDX-License-Identifier: GPL-3.0-or-later
// Front and back planes cut the terrain (docs/decisions/0010-sectors-and-planes.md).
#pragma once

#include "cli/render_settings.hpp"
#include "dem/terrain.hpp"

namespace orograph {

/// Cuts away what is in front of the front plane or behind the back plane of the settings' view,
/// where it has any; what is left is a TIN, whose border runs along the planes. A note tells of it.
/// Throws Error if nothing is left.
void cut_by_view(Terrain& terrain, const RenderSettings& settings);

} // namespace orograph
