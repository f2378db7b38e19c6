// SPDX-License-Identifier: GPL-3.0-or-later
// A triangulated irregular network: the terrain of a survey (docs/how-it-works.md).
#pragma once

#include "geometry/vec.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <ranges>
#include <vector>

namespace orograph {

/// No triangle: beyond an edge of the border.
constexpr std::uint32_t kNoTriangle = 0xffffffff;

/// Triangles over the plane, in metres of the ground frame (true heights), whose origin is near the
/// terrain. Seen from above each triangle runs counterclockwise, no two overlap, and an edge has
/// one triangle or two. A vertical triangle (a wall) has no area seen from above; it runs as its
/// neighbours have it. Triangles may touch at a vertex only, parts may be apart, and there may be
/// holes. `verify` (dem/mesh/verify_tin.hpp) checks all of that.
///
/// An edge is reckoned from its vertex of lower index to the higher, as a Grid's is.
struct Tin {
  std::vector<Vec3> vertices_m;                         ///< finite
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< vertex indices
  std::vector<std::array<std::uint32_t, 3>> neighbours; ///< [t][k]: the triangle on the other side
                                                        ///< of the edge opposite to vertex k of t

  bool operator==(const Tin&) const = default;
};

/// A TIN's triangles are looked at on all cores in so many tasks, of so many each.
constexpr std::size_t kTrianglesAtOnce = 8192;
inline std::size_t tasks_of_triangles(const Tin& tin) {
  return (tin.triangles.size() + kTrianglesAtOnce - 1) / kTrianglesAtOnce;
}
inline auto triangles_of_task(const Tin& tin, std::size_t task) {
  return std::views::iota(
      static_cast<std::uint32_t>(task * kTrianglesAtOnce),
      static_cast<std::uint32_t>(std::min(tin.triangles.size(), (task + 1) * kTrianglesAtOnce)));
}

/// Where a vertex is, seen from above.
inline Vec2 plan_m(const Tin& tin, std::uint32_t vertex) {
  return {tin.vertices_m[vertex].x, tin.vertices_m[vertex].y};
}

/// The area of a triangle as seen from above.
inline double plan_area_m2(const Tin& tin, std::size_t triangle) {
  const auto& [a, b, c] = tin.triangles[triangle];
  const Vec3 ab = tin.vertices_m[b] - tin.vertices_m[a], ac = tin.vertices_m[c] - tin.vertices_m[a];
  return 0.5 * std::abs(ab.x * ac.y - ab.y * ac.x);
}

/// That of all triangles together.
inline double plan_area_m2(const Tin& tin) {
  double sum = 0;
  for (std::size_t t = 0; t < tin.triangles.size(); ++t) sum += plan_area_m2(tin, t);
  return sum;
}

} // namespace orograph
