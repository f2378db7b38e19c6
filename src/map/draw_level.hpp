// SPDX-License-Identifier: GPL-3.0-or-later
// A drawing of a level of the file's surface, and what the file's own surface says of it.
#pragma once

#include "map/draw_map.hpp"
#include "placing/terrain_of_view.hpp"

#include <functional>
#include <optional>

namespace orograph {

/// `draw_map` of a terrain as its view needs it, with the facts of the level that it is drawn in.
/// Where `spec.check_of_file` asks for it, so many points of what is drawn are asked of the file's
/// own surface: hidden is what lies behind that by more than twice what the error budget allows the
/// level, and the visibility tolerance.
Map draw_level(const TerrainOfView& terrain, const PlacedView& placed, const MapSpec& spec,
               const std::optional<LevelOfDetail>& level,
               const std::function<void(double)>& progress, Instruments instruments = {});

/// Throws Error if nothing is on the page of the terrain, or of a scene that stands on nothing.
void check_not_empty(const Map& map, const ViewSpec& view, bool of_scene = false);

} // namespace orograph
