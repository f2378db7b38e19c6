// SPDX-License-Identifier: GPL-3.0-or-later
// `orograph render`: from a DEM to a perspective map on paper.
#pragma once

#include "cli/render_settings.hpp"

namespace orograph {

/// Reads the terrain, draws it and writes the drawing, and the report where one is asked for. Tells
/// on stderr, unless quiet, what it chose for the user. Throws Error; then no output is left.
void render(const RenderSettings& settings);

} // namespace orograph
