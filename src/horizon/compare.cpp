// SPDX-License-Identifier: GPL-3.0-or-later
#include "horizon/compare.hpp"

#include <cmath>

namespace orograph {

Standing compare(const Segment& p, const Segment& s, const TieTolerance& tolerance) {
  using enum Standing::Kind;
  const double low = std::max(p.x0, s.x0), high = std::min(p.x1, s.x1);
  const double at_low = height_difference(p, s, low), at_high = height_difference(p, s, high);

  const double greatest = std::max(std::abs(at_low), std::abs(at_high));
  if (greatest == 0) return {tied};
  if (greatest <= tolerance.greatest_y &&
      std::abs(at_low) <= tolerance.at(low, height_at(p, low)) &&
      std::abs(at_high) <= tolerance.at(high, height_at(p, high)))
    return {tied};
  if (at_low >= 0 && at_high >= 0) return {above};
  if (at_low <= 0 && at_high <= 0) return {below};

  // The parameter comes from the differences, not from the rounded x: on a steep segment one ulp of
  // x is a long way (docs/how-it-works.md).
  const double share = at_low / (at_low - at_high);
  const double x = std::min(low + share * (high - low), high);
  const double t_low = parameter_at(p, low), t_high = parameter_at(p, high);
  return {at_low > 0 ? above_then_below : below_then_above, x, t_low + share * (t_high - t_low)};
}

} // namespace orograph
