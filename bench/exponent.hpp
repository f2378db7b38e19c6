// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <limits>
#include <span>

namespace orograph {

struct SizeAndTime {
  double cells, seconds;
};

/// How time grows with size: the slope of log time over log cells, by least squares. NaN where
/// there are less than two sizes. REQUIRES all of them > 0.
inline double growth_exponent(std::span<const SizeAndTime> measured) {
  const auto n = static_cast<double>(measured.size());
  double mean_x = 0, mean_y = 0;
  for (const auto& [cells, seconds] : measured) {
    mean_x += std::log(cells) / n;
    mean_y += std::log(seconds) / n;
  }
  double xx = 0, xy = 0;
  for (const auto& [cells, seconds] : measured) {
    const double dx = std::log(cells) - mean_x;
    xx += dx * dx;
    xy += dx * (std::log(seconds) - mean_y);
  }
  return xx > 0 ? xy / xx : std::numeric_limits<double>::quiet_NaN();
}

} // namespace orograph
