// SPDX-License-Identifier: GPL-3.0-or-later
// `orograph render`: from a DEM to a perspective map on paper.
#pragma once

#include "cli/render_settings.hpp"
#include "dem/terrain.hpp"
#include "map/draw_map.hpp"

#include <string>

namespace orograph {

/// Whether INPUT is a scene, which is drawn alone.
bool is_scene(const std::string& input);
/// Whether it is the only one.
bool stands_on_nothing(const RenderSettings& settings);

/// The terrain that the settings name; of a scene alone one without ground (`has_ground`). Throws
/// Error as `read_terrain` does.
TerrainData read_ground(const RenderSettings& settings);

/// Throws Error if nothing is on the page.
void check_not_empty(const Map& map, const RenderSettings& settings);

/// Reads the terrain, draws it and writes the drawing, and the report where one is asked for. Tells
/// on stderr, unless quiet, what it chose for the user. Throws Error; then no output is left.
void render(const RenderSettings& settings);

} // namespace orograph
