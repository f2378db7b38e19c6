// SPDX-License-Identifier: GPL-3.0-or-later
// What an eye sees of a place, and its skyline all round.
#pragma once

#include "geometry/vec.hpp"

#include <optional>
#include <vector>

namespace orograph {

/// A direction and a distance from the eye. Where the terrain's CRS tells where on the earth it is,
/// azimuths are from true north, and they and distances those of the geodesic; else those of the
/// map.
struct Bearing {
  double azimuth_deg = 0;  ///< clockwise, in [0, 360)
  double altitude_deg = 0; ///< above the eye's horizontal, as drawn: curved, refracted, exaggerated
  double distance_m = 0;   ///< along the ground
};

enum class PlaceState {
  seen,   ///< on the horizon of what is in front, to rounding, too
  hidden, ///< by the terrain
  gap,    ///< within the terrain's bounds, where it has no heights
  outside ///< beyond the terrain
};

/// A place on the ground, or as high above it as asked for.
struct PlaceSight {
  PlaceState state = PlaceState::outside;
  Bearing bearing;   ///< of no place on the terrain only azimuth and distance
  double height = 0; ///< of the place, true, in the unit of the terrain's heights
  /// By how much it would have to be higher to be seen, and what that is for the eye; 0 where it is
  /// seen.
  double hidden_m = 0, hidden_deg = 0;
  bool tied = false; ///< seen or hidden by no more than rounding
};

/// A place of the skyline: the highest ground in its direction, and the farthest that is seen
/// there.
struct SkylinePlace {
  Bearing bearing;
  Vec2 map;                   ///< in map coordinates
  std::optional<Vec2> lonlat; ///< none where the CRS isn't on the earth
  double height = 0;          ///< true, in the unit of the terrain's heights
  bool at_border = false;     ///< the terrain ends there: what is beyond isn't known
};

struct Skyline {
  struct Direction {
    double azimuth_deg = 0;
    std::optional<SkylinePlace> place; ///< none: there is no ground in that direction
  };
  std::vector<Direction> directions;
  std::optional<SkylinePlace> most_distant; ///< of these directions and others between
};

} // namespace orograph
