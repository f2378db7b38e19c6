// SPDX-License-Identifier: GPL-3.0-or-later
// The sample terrains in data_samples that are grids on a map.
#pragma once

#include <array>
#include <span>

namespace orograph {

/// All in optimized builds; in others, which are there for the sanitizers, the first two.
inline std::span<const char* const> sample_names() {
  static constexpr std::array<const char*, 8> kNames{"volcano",      "islands",  "cone",
                                                     "plateau",      "saddle",   "ridge_and_valley",
                                                     "fractal_alps", "jacksboro"};
#ifdef NDEBUG
  return kNames;
#else
  return std::span(kNames).first(2);
#endif
}

} // namespace orograph
