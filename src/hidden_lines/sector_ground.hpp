// SPDX-License-Identifier: GPL-3.0-or-later
// What of the ground a drawing's sectors look at.
#pragma once

#include "dem/terrain.hpp"
#include "hidden_lines/instruments.hpp"
#include "placing/map_spec.hpp"
#include "placing/placed_view.hpp"
#include "profiles/seen_ground.hpp"

#include <optional>
#include <vector>

namespace orograph {

/// For each sector of a placed view the blocks of the grid that it looks at. Empty where all ground
/// is looked at: of TINs, of grids that the ellipsoid turns triangles of over, where not all of the
/// surface hides, and where the instruments want it.
std::vector<SeenGround> ground_of_sectors(const TerrainData& terrain, const PlacedView& placed,
                                          const Style& style, const Instruments& instruments);

/// The blocks that any sector looks at; none where all ground is looked at.
std::optional<SeenGround> looked_at_by_any(const std::vector<SeenGround>& ground);

} // namespace orograph
