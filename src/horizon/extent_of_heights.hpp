// SPDX-License-Identifier: GPL-3.0-or-later
// How a line stands to others over a stretch of X, as its two ends tell.
#pragma once

#include "geometry/segment.hpp"

#include <algorithm>
#include <cmath>

namespace orograph {

/// Heights of a line over a stretch of X.
struct Extent {
  double low, high;
};
inline Extent extent_of(const Segment& s, double begin, double end) {
  const double a = height_at(s, begin), b = height_at(s, end);
  return {std::min(a, b), std::max(a, b)};
}

/// More than rounding adds to heights like these.
inline double rounding_of(Extent extent) {
  return 1e-12 * (std::abs(extent.low) + std::abs(extent.high));
}

/// A line's height above a source at both ends of a stretch that they share.
struct HeightAbove {
  double at_begin, at_end;

  bool is_more_than(double apart) const { return at_begin > apart && at_end > apart; }
  bool is_less_than(double apart) const { return at_begin < apart && at_end < apart; }
};
inline HeightAbove height_above(const Segment& line, const Segment& source, double begin,
                                double end) {
  return {height_difference(line, source, begin), height_difference(line, source, end)};
}

} // namespace orograph
