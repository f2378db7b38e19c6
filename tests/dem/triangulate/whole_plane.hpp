// SPDX-License-Identifier: GPL-3.0-or-later
// Brute force over points with whole coordinates, in integers: no rounding.
#pragma once

#include "dem/tin.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace orograph {

__extension__ using Wide = __int128;

struct Whole {
  std::int64_t x, y;
  auto operator<=>(const Whole&) const = default;
};

inline Whole whole(const Vec3& p) {
  return {std::llround(p.x), std::llround(p.y)};
}

/// Twice the area of a triangle, positive counterclockwise.
inline std::int64_t doubled_area(Whole a, Whole b, Whole c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// True strictly within the circle through a, b, c, which run counterclockwise.
inline bool in_circle(Whole a, Whole b, Whole c, Whole d) {
  const auto row = [&](Whole p) {
    const Wide x = p.x - d.x, y = p.y - d.y;
    return std::array<Wide, 3>{x, y, x * x + y * y};
  };
  const auto [ax, ay, aw] = row(a);
  const auto [bx, by, bw] = row(b);
  const auto [cx, cy, cw] = row(c);
  return ax * (by * cw - bw * cy) - ay * (bx * cw - bw * cx) + aw * (bx * cy - by * cx) > 0;
}

/// Twice the area of the convex hull (Andrew 1979).
inline std::int64_t doubled_hull_area(std::vector<Whole> points) {
  std::sort(points.begin(), points.end());
  std::vector<Whole> hull;
  for (int half = 0; half < 2; ++half) {
    const std::size_t begin = hull.size();
    for (const Whole p : points) {
      while (hull.size() >= begin + 2 && doubled_area(hull[hull.size() - 2], hull.back(), p) <= 0)
        hull.pop_back();
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  std::int64_t area = 0;
  for (std::size_t k = 2; k < hull.size(); ++k) area += doubled_area(hull[0], hull[k - 1], hull[k]);
  return area;
}

inline std::vector<Vec3> random_points(Random& random, int count, int side) {
  std::vector<Vec3> points;
  for (int k = 0; k < count; ++k)
    points.push_back({double(random.whole(-side, side)), double(random.whole(-side, side)),
                      random.between(-50, 900)});
  return points;
}

} // namespace orograph
