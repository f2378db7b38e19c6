// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/highest_triangle.hpp"

#include "dem/common_ground.hpp"
#include "dem/neighbours.hpp"
#include "dem/orientation.hpp"
#include "dem/tin_index.hpp"

namespace orograph {
namespace {

bool holds(const Tin& tin, std::uint32_t triangle, Vec2 p) {
  for (std::uint32_t k = 0; k < 3; ++k) {
    const auto [i, j] = ends_of(tin.triangles[triangle], k);
    const Vec3 &a = tin.vertices_m[i], &b = tin.vertices_m[j];
    if (orientation({a.x, a.y}, {b.x, b.y}, p) < 0) return false;
  }
  return true;
}

} // namespace

std::vector<std::uint32_t> highest_triangles(const Tin& tin, std::span<const std::uint32_t> chosen,
                                             std::span<const Vec2> points, double tolerance_m) {
  Tin part{tin.vertices_m, {}, {}};
  for (const std::uint32_t t : chosen) part.triangles.push_back(tin.triangles[t]);
  const TinIndex index(part);
  std::vector<std::uint32_t> highest, near;
  for (const Vec2 p : points) {
    std::uint32_t found = kNoTriangle;
    double height_m = 0;
    index.meeting({p, p}, near);
    for (const std::uint32_t t : near) {
      if (!holds(part, t, p)) continue;
      const double here = height_on(part, t, p);
      if (found != kNoTriangle && here <= height_m + tolerance_m) continue;
      found = chosen[t];
      height_m = here;
    }
    highest.push_back(found);
  }
  return highest;
}

} // namespace orograph
