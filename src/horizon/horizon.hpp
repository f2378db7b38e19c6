// SPDX-License-Identifier: GPL-3.0-or-later
// The horizon: what the occluders in front reach up to, at each X of the visibility plane.
#pragma once

#include "geometry/segment.hpp"

#include <cstddef>
#include <limits>
#include <vector>

namespace orograph {

/// The part of a source segment between two abscissae.
struct HorizonPiece {
  double x_begin, x_end;
  Segment source; ///< its line is the height; for the sky see `is_sky`
  bool inked;     ///< a line is drawn along it
};

/// Source id of the horizon before anything stands: height -infinity.
constexpr std::uint64_t kSky = std::numeric_limits<std::uint64_t>::max();
inline bool is_sky(const HorizonPiece& piece) {
  return piece.source.id == kSky;
}

/// Pieces that tile X from -infinity to +infinity, in order.
using Horizon = std::vector<HorizonPiece>;

/// The sky alone.
inline Horizon initial_horizon() {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return {{-infinity, infinity, {-infinity, -infinity, infinity, -infinity, kSky}, false}};
}

} // namespace orograph
