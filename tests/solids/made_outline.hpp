// SPDX-License-Identifier: GPL-3.0-or-later
// Random polygons that are simple by the way they are made.
#pragma once

#include "geometry/vec.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace orograph {

/// Corners at growing angles about a point: seldom convex.
inline std::vector<Vec2> star_outline(Random& random, int corners) {
  std::vector<Vec2> outline;
  const Vec2 centre{random.between(-50, 50), random.between(-50, 50)};
  for (int i = 0; i < corners; ++i) {
    const double angle = (i + random.between(0.05, 0.95)) * 2 * M_PI / corners;
    outline.push_back(centre + random.between(1, 10) * Vec2{std::cos(angle), std::sin(angle)});
  }
  return outline;
}

/// Upright teeth on a bar, with corners in a row along its foot.
inline std::vector<Vec2> comb_outline(Random& random, int teeth) {
  std::vector<Vec2> outline;
  for (int i = 0; i <= teeth; ++i) outline.push_back({2.0 * i, 0});
  for (int i = teeth; i-- > 0;) {
    const double height = random.between(2, 9);
    outline.push_back({2.0 * i + 1.5, 1});
    outline.push_back({2.0 * i + 1.5, height});
    outline.push_back({2.0 * i + 0.5, height});
    outline.push_back({2.0 * i + 0.5, 1});
  }
  return outline;
}

inline std::vector<Vec2> any_outline(Random& random) {
  std::vector<Vec2> outline = random.chance(0.7) ? star_outline(random, random.whole(3, 40))
                                                 : comb_outline(random, random.whole(1, 10));
  if (random.chance(0.5)) std::reverse(outline.begin(), outline.end());
  return outline;
}

} // namespace orograph
