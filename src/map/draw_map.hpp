// SPDX-License-Identifier: GPL-3.0-or-later
// The pipeline between reading and writing: for each depth, front to back, cut, project, clip,
// draw.
#pragma once

#include "dem/terrain.hpp"
#include "draw/drawing.hpp"
#include "hidden_lines/instruments.hpp"
#include "map/map_facts.hpp"
#include "placing/map_spec.hpp"
#include "placing/placed_view.hpp"

#include <functional>

namespace orograph {

/// Draws the layers that `spec` asks for, and entitles the drawing. Of the facts it knows counts,
/// check, what was left out, and the seconds of its own stages; `describe_map` adds the others.
/// `progress` is told the share done, after each profile.
Map draw_map(const TerrainData& terrain, const PlacedView& placed, const MapSpec& spec,
             const std::function<void(double)>& progress, Instruments instruments = {});

} // namespace orograph
