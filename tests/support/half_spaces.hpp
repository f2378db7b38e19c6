// SPDX-License-Identifier: GPL-3.0-or-later
// Triangles cut by half-spaces in long double, for tests by definition; shares no code with dem/.
#pragma once

#include "dem/mesh/half_space.hpp"
#include "geometry/vec.hpp"

#include <array>
#include <cmath>
#include <span>
#include <vector>

namespace orograph {

struct LongPoint {
  long double x, y, z;
};

/// Above zero beyond the plane, in metres.
inline long double metres_beyond(const HalfSpace& space, LongPoint p) {
  const Vec3& n = space.normal;
  return (n.x * p.x + n.y * p.y + n.z * p.z - space.offset) /
         std::hypot(static_cast<long double>(n.x), n.y, n.z);
}
inline LongPoint long_point(const Vec3& p) {
  return {p.x, p.y, p.z};
}

/// How far a point is beyond the plane that it is farthest beyond; below zero within all.
inline long double metres_beyond(std::span<const HalfSpace> spaces, LongPoint p) {
  long double farthest = -1e300L;
  for (const HalfSpace& space : spaces) farthest = std::max(farthest, metres_beyond(space, p));
  return farthest;
}

/// The part of a convex polygon, or of a line by its two ends, within all.
inline std::vector<LongPoint> part_within(std::vector<LongPoint> polygon,
                                          std::span<const HalfSpace> spaces) {
  for (const HalfSpace& space : spaces) {
    std::vector<LongPoint> within;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const LongPoint p = polygon[i], q = polygon[(i + 1) % polygon.size()];
      const long double at_p = metres_beyond(space, p), at_q = metres_beyond(space, q);
      if (at_p <= 0) within.push_back(p);
      if ((at_p < 0 && at_q > 0) || (at_p > 0 && at_q < 0)) {
        const long double s = at_p / (at_p - at_q);
        within.push_back({p.x + s * (q.x - p.x), p.y + s * (q.y - p.y), p.z + s * (q.z - p.z)});
      }
    }
    polygon = std::move(within);
  }
  return polygon;
}

struct Areas {
  long double in_plan = 0, in_space = 0;
};

inline Areas areas_of(const std::vector<LongPoint>& polygon) {
  Areas areas;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    const LongPoint a = polygon[0], b = polygon[i], c = polygon[i + 1];
    const long double x1 = b.x - a.x, y1 = b.y - a.y, z1 = b.z - a.z;
    const long double x2 = c.x - a.x, y2 = c.y - a.y, z2 = c.z - a.z;
    const long double nz = x1 * y2 - y1 * x2;
    areas.in_plan += nz / 2;
    areas.in_space += std::hypot(y1 * z2 - z1 * y2, z1 * x2 - x1 * z2, nz) / 2;
  }
  return areas;
}

} // namespace orograph
