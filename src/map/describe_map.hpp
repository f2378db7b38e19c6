// SPDX-License-Identifier: GPL-3.0-or-later
// From a map that was drawn to what there is to say of it.
#pragma once

#include "dem/terrain.hpp"
#include "map/draw_map.hpp"
#include "placing/placed_view.hpp"
#include "placing/terrain_of_view.hpp"

namespace orograph {

/// Sets title and description: the title as given, else what the terrain was read from.
void entitle(Drawing& drawing, const TerrainData& terrain, const PlacedView& placed,
             const std::string& title);

/// Completes the facts of a map that `draw_map` made of these: where its terrain comes from, how it
/// is seen, its error budget and the pen's travel. Costs some transformations between the terrain's
/// CRS and longitudes and latitudes, milliseconds, and a pass over the drawing's points.
void describe_map(Map& map, const TerrainOfView& of_view, const PlacedView& placed,
                  const MapSpec& spec);

/// How it is seen, without the earth's curvature.
ViewFacts describe_view(const PlacedView& placed, const TerrainData& terrain, const MapSpec& spec);

} // namespace orograph
