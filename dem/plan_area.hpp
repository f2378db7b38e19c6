// SPDX-License-Identifier: GPL-3.0-or-later
// Areas of a TIN as seen from above.
#pragma once

#include "dem/tin.hpp"

#include <cmath>

namespace orograph {

inline double plan_area_m2(const Tin& tin, std::size_t triangle) {
  const auto& [a, b, c] = tin.triangles[triangle];
  const Vec3 ab = tin.vertices_m[b] - tin.vertices_m[a], ac = tin.vertices_m[c] - tin.vertices_m[a];
  return 0.5 * std::abs(ab.x * ac.y - ab.y * ac.x);
}

inline double plan_area_m2(const Tin& tin) {
  double sum = 0;
  for (std::size_t t = 0; t < tin.triangles.size(); ++t) sum += plan_area_m2(tin, t);
  return sum;
}

} // namespace orograph
