// SPDX-License-Identifier: GPL-3.0-or-later
// A terrain in cells as small as a map needs them, and no smaller.
#pragma once

#include "dem/read/read_options.hpp"
#include "dem/terrain.hpp"
#include "placing/map_spec.hpp"
#include "solids/scene_file.hpp"

#include <functional>
#include <string>
#include <vector>

namespace orograph {

/// The terrain of these files; of a raster of more than 16 million heights, whose page shows it
/// whole, larger cells: not larger than those that `choose_level` draws, which are half as large
/// mostly. The whole raster where `spec` draws its own surface, looks from an eye or a file's view,
/// or is checked against the file. Throws the Errors of `read_terrain`; `progress` as of that.
TerrainData read_for_map(const std::vector<std::string>& paths, const ReadOptions& options,
                         const MapSpec& spec, const SceneFile* solids,
                         const std::function<void(double)>& progress = {});

} // namespace orograph
