// SPDX-License-Identifier: GPL-3.0-or-later
// Texts, and what belongs to them, on a drawing whose lines are on the page.
#pragma once

#include "dem/terrain.hpp"
#include "map/map_facts.hpp"
#include "placing/map_spec.hpp"
#include "placing/placed_view.hpp"

#include "lettering/lettering.hpp"
#include "naming/line_labels.hpp"

namespace orograph {

/// Adds names, the labels of `lines` and furniture, and makes strokes of texts where their letters
/// are strokes. A drawing whose lines keep their places on the ground, which has no page, gets
/// neither.
void letter_map(Map& map, const TerrainData& terrain, const PlacedView& placed, const MapSpec& spec,
                const LinesToLabel& lines);

} // namespace orograph
