// SPDX-License-Identifier: GPL-3.0-or-later
// Where the ground frame of a terrain in degrees has its origin.
#pragma once

#include "cli/render_settings.hpp"
#include "dem/terrain.hpp"

namespace orograph {

/// Of a terrain in degrees: puts the origin of its ground frame below the eye, where no eye is
/// given below the target, else in the terrain's middle, and exaggerates its heights, before the
/// earth curves them away. A view in a file has its directions in the frame below its own eye, of a
/// parallel view at its VRP. Other terrains are left as they are. Throws the Errors of `place_eye`
/// and of `reframe`.
void stand_on_earth(Terrain& terrain, const RenderSettings& settings);

} // namespace orograph
