// SPDX-License-Identifier: GPL-3.0-or-later
// The grid of a terrain that has one.
#pragma once

#include "dem/terrain.hpp"

#include <utility>
#include <variant>

namespace orograph {

inline Grid& grid_of(TerrainData& terrain) {
  return std::get<Grid>(terrain.surface);
}
inline const Grid& grid_of(const TerrainData& terrain) {
  return std::get<Grid>(terrain.surface);
}
inline Grid grid_of(TerrainData&& terrain) {
  return std::get<Grid>(std::move(terrain.surface));
}

} // namespace orograph
