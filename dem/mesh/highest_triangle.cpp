// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/mesh/highest_triangle.hpp"

#include "dem/mesh/common_ground.hpp"
#include "dem/mesh/neighbours.hpp"
#include "dem/mesh/orientation.hpp"
#include "dem/mesh/tin_index.hpp"

namespace orograph {
namespace {

using Face = std::array<Vec2, 3>;

// A face may run over the hidden edge of a triangle, which doesn't hold all of it then: its middle
// alone could lie on that edge, at the height of what hides it.
bool holds(const Tin& tin, std::uint32_t triangle, const Face& face, double tolerance_m) {
  for (std::uint32_t k = 0; k < 3; ++k) {
    const auto [i, j] = ends_of(tin.triangles[triangle], k);
    const Vec2 from{tin.vertices_m[i].x, tin.vertices_m[i].y};
    const Vec2 along = Vec2{tin.vertices_m[j].x, tin.vertices_m[j].y} - from;
    for (const Vec2 corner : face)
      if (cross(along, corner - from) < -tolerance_m * length(along)) return false;
  }
  return true;
}

bool is_over(const Tin& tin, std::uint32_t triangle, Vec2 p) {
  for (std::uint32_t k = 0; k < 3; ++k) {
    const auto [i, j] = ends_of(tin.triangles[triangle], k);
    const Vec3 &a = tin.vertices_m[i], &b = tin.vertices_m[j];
    if (orientation({a.x, a.y}, {b.x, b.y}, p) < 0) return false;
  }
  return true;
}

} // namespace

std::vector<std::uint32_t> highest_triangles(const Tin& tin, std::span<const std::uint32_t> chosen,
                                             std::span<const std::uint32_t> whole,
                                             const PlanArrangement& arrangement,
                                             double tolerance_m) {
  Tin part{tin.vertices_m, {}, {}}; // those chosen, then those whole
  for (const std::uint32_t t : chosen) part.triangles.push_back(tin.triangles[t]);
  for (const std::uint32_t t : whole) part.triangles.push_back(tin.triangles[t]);
  const TinIndex index(part);
  std::vector<std::uint32_t> highest, near;
  for (const auto& [a, b, c] : arrangement.faces) {
    const Face face{arrangement.points[a], arrangement.points[b], arrangement.points[c]};
    const Vec2 middle = (1.0 / 3) * (face[0] + face[1] + face[2]);
    std::uint32_t found = kNoTriangle;
    double height_m = 0;
    index.meeting({middle, middle}, near);
    for (const std::uint32_t t : near) {
      // The whole ones come last and undo what was found.
      if (t >= chosen.size() && is_over(part, t, middle)) found = kNoTriangle;
      if (t >= chosen.size() || !holds(part, t, face, tolerance_m)) continue;
      const double here = height_on(part, t, middle);
      if (found != kNoTriangle && here <= height_m + tolerance_m) continue;
      found = chosen[t];
      height_m = here;
    }
    highest.push_back(found);
  }
  return highest;
}

} // namespace orograph
