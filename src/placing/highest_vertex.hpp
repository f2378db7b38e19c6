// SPDX-License-Identifier: GPL-3.0-or-later
// The highest ground about places.
#pragma once

#include "dem/terrain.hpp"
#include "geometry/vec.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace orograph {

/// A vertex near a place.
struct HighestVertex {
  std::uint32_t vertex = 0; ///< number
  Vec2 map;                 ///< where it is, in map coordinates
  double height_m = 0;      ///< true
  double distance_m = 0;    ///< along the ground from the place
};

/// For each place, in map coordinates, the highest vertex of a triangle within `within_m` along the
/// ground; of several that are as high the nearest. None: there is no ground so near. REQUIRES of a
/// TIN that it is on a map plane. Cost: of a grid, the vertices within, on all cores; of a TIN, one
/// pass over all of it.
std::vector<std::optional<HighestVertex>>
highest_vertices(const TerrainData& terrain, std::span<const Vec2> places, double within_m);

} // namespace orograph
