// SPDX-License-Identifier: GPL-3.0-or-later
// The highest ground about the place where an eye is put.
#pragma once

#include "dem/terrain.hpp"
#include "placing/map_spec.hpp"

#include <optional>

namespace orograph {

/// From where an eye was put to the highest ground about it.
struct EyeMove {
  Vec2 from_map, to_map;
  double distance_m = 0;             ///< 0: it stays
  std::optional<double> from_m = {}; ///< true height of the ground there; none: there is no ground
  double to_m = 0;
};

/// To the highest vertex of the terrain within `eye_summit_m` of the eye's place, along the ground;
/// of several that are as high the nearest. It stays where no vertex there is higher than its own
/// place. None where the view doesn't ask for it. Throws Error as `place_on_map` does, and where
/// there is no ground within that distance. Cost: of a grid, the vertices within; of a TIN, all.
std::optional<EyeMove> eye_move(const ViewSpec& view, const TerrainData& terrain);

/// The view with its eye there, as high above the ground as it was, and without the wish; itself
/// where it has none. Throws the same, and where its height above the ground isn't known.
ViewSpec on_summit(const ViewSpec& view, const TerrainData& terrain);

} // namespace orograph
