// SPDX-License-Identifier: GPL-3.0-or-later
// Sampled profiles without a terrain.
#pragma once

#include "tests/support/random.hpp"

#include <cmath>
#include <limits>
#include <vector>

#include "tone/sampled_profile.hpp"

namespace orograph {

/// Seen in parallel with Y = z and 1 mm a unit: heights are places on the page, and up is down.
inline View upright_view() {
  View view;
  view.projection = Projection::orthographic;
  view.y_per_z = 1;
  return view;
}

inline SampledProfile sampled(double depth_m, const std::vector<double>& z_m,
                              const PageColumns& columns) {
  SampledProfile profile;
  profile.depth_m = depth_m;
  profile.z_m = z_m;
  profile.is_level.assign(z_m.size(), 0);
  for (std::size_t i = 0; i < z_m.size(); ++i) {
    const double x_mm = columns.mm * static_cast<double>(i);
    profile.x_mm.push_back(static_cast<float>(std::isnan(z_m[i]) ? z_m[i] : x_mm));
    profile.y_mm.push_back(static_cast<float>(-z_m[i]));
  }
  return profile;
}

/// In whole steps, so that heights are often equal, with missing ones.
inline std::vector<SampledProfile> made_profiles(Random& random, const PageColumns& columns) {
  std::vector<SampledProfile> profiles;
  const int count = random.whole(1, 30);
  double base = 0;
  for (int j = 0; j < count; ++j) {
    base += random.between(-1, 2);
    std::vector<double> z_m;
    for (std::size_t i = 0; i < columns.count; ++i)
      z_m.push_back(random.chance(0.1) ? std::numeric_limits<double>::quiet_NaN()
                                       : std::round(base + random.between(0, 4)));
    profiles.push_back(sampled(10.0 * j, z_m, columns));
  }
  return profiles;
}

} // namespace orograph
