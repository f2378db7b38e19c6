// SPDX-License-Identifier: GPL-3.0-or-later
// The size of cells that a page shows (docs/decisions/0045-level-of-detail.md).
#pragma once

#include "dem/levels/level_of_detail.hpp"
#include "placing/map_spec.hpp"
#include "placing/terrain_of_view.hpp"
#include "solids/scene_file.hpp"

#include <optional>

namespace orograph {

/// Where the page is to show the terrain in cells of `spec.style.detail` and the file's are half or
/// twice as large, `terrain` becomes a level of itself: generalised, or refined up to a million
/// vertices; where an eye stands over it, a TIN of patches of both. None: it stays as it is; so do
/// TINs and what the view's planes cut. Other views' level is taken, where that has the size, and
/// one that is made is kept for them. Cost: some 10 ns a height of the file, 60 ns one of what is
/// refined, and 0.5 us a vertex of patches.
std::optional<LevelOfDetail> choose_level(TerrainOfView& terrain, const MapSpec& spec,
                                          const SceneFile* solids);

} // namespace orograph
