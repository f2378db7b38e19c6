// SPDX-License-Identifier: GPL-3.0-or-later
// Which way three points run seen from above, exactly.
#pragma once

#include "geometry/vec.hpp"

#include <cmath>

namespace orograph {

/// What `orientation` asks where doubles alone can't tell: by exact arithmetic, for any finite
/// doubles; slow. (In plane_triangulation.cpp, beside all else that is CGAL's.)
int exact_orientation(Vec2 a, Vec2 b, Vec2 c);

/// 1 where a, b, c run counterclockwise, -1 where clockwise, 0 where they are on one line. Right
/// for any finite doubles; fast where the answer isn't close.
inline int orientation(Vec2 a, Vec2 b, Vec2 c) {
  const double left = (a.x - c.x) * (b.y - c.y), right = (a.y - c.y) * (b.x - c.x);
  const double area = left - right, size = std::abs(left) + std::abs(right);
  // The rounding of differences, products and the last difference: 3 units of 2^-53 of `size`, and
  // a little (Shewchuk 1997, section 4.3). Below 1e-280 products lose bits; beyond the range of
  // doubles they are infinite or no numbers, and comparisons fail.
  if (size > 1e-280 && std::abs(area) > 3.4e-16 * size) return area > 0 ? 1 : -1;
  return exact_orientation(a, b, c);
}

/// The same for three points in space.
inline int plan_orientation(const Vec3& a, const Vec3& b, const Vec3& c) {
  return orientation({a.x, a.y}, {b.x, b.y}, {c.x, c.y});
}

/// True where three points in space are on one line.
inline bool on_one_line(const Vec3& a, const Vec3& b, const Vec3& c) {
  return orientation({a.x, a.y}, {b.x, b.y}, {c.x, c.y}) == 0 &&
         orientation({a.y, a.z}, {b.y, b.z}, {c.y, c.z}) == 0 &&
         orientation({a.z, a.x}, {b.z, b.x}, {c.z, c.x}) == 0;
}

} // namespace orograph
