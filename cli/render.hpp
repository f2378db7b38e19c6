// SPDX-License-Identifier: GPL-3.0-or-later
// `orograph render`: from a DEM to a perspective map on paper.
#pragma once

#include "cli/render_settings.hpp"
#include "map/draw_map.hpp"

namespace orograph {

/// Throws Error if nothing is on the page.
void check_not_empty(const Map& map, const RenderSettings& settings);

/// Reads the terrain, draws it and writes the drawing, and the report where one is asked for. Tells
/// on stderr, unless quiet, what it chose for the user. Throws Error; then no output is left.
void render(const RenderSettings& settings);

} // namespace orograph
