// SPDX-License-Identifier: GPL-3.0-or-later
// The seed's method in exact rational arithmetic, to see what arithmetic in double costs.
#pragma once

#include "hidden_lines/instruments.hpp"
#include "map/draw_map.hpp"

namespace orograph {

/// What profiles alone hide, by `exact_clip`: told to the observer and counted, not drawn.
/// Memory: all projected profiles.
Map draw_exactly(const TerrainData& terrain, const PlacedView& scene,
                 const std::vector<LineObserver*>& observers);

} // namespace orograph
