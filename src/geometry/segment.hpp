// SPDX-License-Identifier: GPL-3.0-or-later
// A source segment: a projected straight line of the terrain in the visibility plane.
#pragma once

#include <cmath>
#include <cstdint>

namespace orograph {

/// From (x0, y0) to (x1, y1) with x0 < x1, in the coordinates of the visibility plane (per unit of
/// depth in perspective, metres in a parallel view). Pieces of it are told by `id`: two segments
/// with one id are the same segment.
struct Segment {
  double x0, y0, x1, y1;
  std::uint64_t id;
};

/// Height of the segment's line at x0 <= x <= x1; exactly y0 at x0 and y1 at x1. It is reckoned
/// from the nearer end, so its error is a few ulp of max(|y0|, |y1|) plus slope * ulp(x).
inline double height_at(const Segment& s, double x) {
  const double from_left = x - s.x0, from_right = s.x1 - x;
  const double slope = (s.y1 - s.y0) / (s.x1 - s.x0);
  return from_left <= from_right ? s.y0 + from_left * slope : s.y1 - from_right * slope;
}

} // namespace orograph
