// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/render_settings.hpp"
#include "dem/terrain.hpp"

#include <string>

namespace orograph {

/// Whether INPUT is a scene, which is drawn alone.
bool is_scene(const std::string& input);

/// The terrain that the settings name; of a scene alone one without ground (`has_ground`). Throws
/// Error as `read_terrain` does.
TerrainData read_ground(const RenderSettings& settings);

} // namespace orograph
