// SPDX-License-Identifier: GPL-3.0-or-later
// The sample terrains in data_samples that are grids on a map.
#pragma once

#include "tests/support/slow_build.hpp"

#include <array>
#include <span>

namespace orograph {

/// All; in slow builds, which are there for the sanitizers, the first two.
inline std::span<const char* const> sample_names() {
  static constexpr std::array<const char*, 8> kNames{"volcano",      "islands",  "cone",
                                                     "plateau",      "saddle",   "ridge_and_valley",
                                                     "fractal_alps", "jacksboro"};
  return std::span(kNames).first(is_slow_build() ? 2 : kNames.size());
}

} // namespace orograph
