// SPDX-License-Identifier: GPL-3.0-or-later
// How two source segments stand to each other, and the tolerance below which they are one line.
#pragma once

#include "geometry/homography.hpp"
#include "geometry/segment.hpp"

#include <algorithm>
#include <cmath>

namespace orograph {

/// The visibility tolerance τ (docs/how-it-works.md): a length on paper, turned into a
/// difference of Y at a place.
struct TieTolerance {
  double mm = 0; ///< 0 compares exactly
  Homography page;
  double greatest_y = 0; ///< greatest difference of Y that `mm` means on the page shown

  double at(double x, double y) const {
    const Vec2 place{x, y};
    if (!(page.w(place) > 0)) return 0;
    return std::min(greatest_y, mm / page.mm_per_y(place));
  }
};

/// Where segment p stands against source s, along all of the X range that the two share. A function
/// of the two alone and not of the pieces they are cut to, so it doesn't matter how a horizon has
/// fragmented.
struct Standing {
  enum class Kind { above, below, tied, above_then_below, below_then_above } kind;
  double x = 0; ///< the crossing, for the last two kinds
  double t = 0; ///< the same along p, 0 at p's left end and 1 at its right end
};

/// Where abscissa x is along p: 0 at its left end and before, and 1 at its right end and behind,
/// exactly. A quotient of equal numbers is 1, and no branch is to be foreseen.
inline double parameter_at(const Segment& p, double x) {
  return std::min(std::max(0.0, (x - p.x0) / (p.x1 - p.x0)), 1.0);
}

/// Of two whose difference changes its sign between two abscissae.
inline Standing crossing(const Segment& p, double low, double high, double at_low, double at_high) {
  using enum Standing::Kind;
  // The parameter comes from the differences, not from the rounded x: on a steep segment one ulp of
  // x is a long way (docs/how-it-works.md).
  const double share = at_low / (at_low - at_high);
  const double x = std::min(low + share * (high - low), high);
  const double t_low = parameter_at(p, low), t_high = parameter_at(p, high);
  return {at_low > 0 ? above_then_below : below_then_above, x, t_low + share * (t_high - t_low)};
}

/// REQUIRES that p and s share a range of X of positive length, and that s isn't the sky.
/// `tied` where the greatest difference over the shared range is within the least tolerance there.
inline Standing compare(const Segment& p, const Segment& s, const TieTolerance& tolerance) {
  using enum Standing::Kind;
  const double low = std::max(p.x0, s.x0), high = std::min(p.x1, s.x1);
  const double at_low = height_difference(p, s, low), at_high = height_difference(p, s, high);

  const double greatest = std::max(std::abs(at_low), std::abs(at_high));
  // In perspective the tolerance grows with the square of what the ends' differences grow with, so
  // each within its own end's may be far apart on paper between them.
  if (greatest <= tolerance.greatest_y &&
      (greatest == 0 || (greatest <= tolerance.at(low, height_at(p, low)) &&
                         greatest <= tolerance.at(high, height_at(p, high)))))
    return {tied};
  if (at_low >= 0 && at_high >= 0) return {above};
  if (at_low <= 0 && at_high <= 0) return {below};
  return crossing(p, low, high, at_low, at_high);
}

} // namespace orograph
