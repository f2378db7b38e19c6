// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/vec.hpp"

#include <algorithm>

namespace orograph {

/// From a point to the nearest of a segment.
inline double to_segment(Vec2 p, Vec2 a, Vec2 b) {
  const Vec2 along = b - a;
  const double squared = dot(along, along);
  const double t = squared > 0 ? std::clamp(dot(p - a, along) / squared, 0.0, 1.0) : 0;
  return length(p - (a + t * along));
}

} // namespace orograph
