// SPDX-License-Identifier: GPL-3.0-or-later
// Walls that don't stand on pairs of vertices; shares no code with dem/.
#pragma once

#include "tests/support/made_tin.hpp"

#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace orograph {

/// Splits edges in the middle on one side only, and moves the new vertex up or down: between the
/// two sides stands a wall over three different places. The Tin stays valid. Only edges with whole
/// coordinates, on which the middle lies exactly.
inline void add_notches(Tin& tin, Random& random, double probability) {
  // Twice the area seen from above; exact for whole coordinates of up to 2^30.
  const auto area = [&](const Vec3& a, const Vec3& b, const Vec3& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  };
  const auto is_ground = [&](std::uint32_t t) {
    const auto& [a, b, c] = tin.triangles[t];
    return area(tin.vertices_m[a], tin.vertices_m[b], tin.vertices_m[c]) > 0;
  };
  std::vector<bool> done(tin.triangles.size(), false);
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (std::uint32_t t = 0; t < done.size(); ++t) {
    done[t] = true;
    const auto triangle = tin.triangles[t];
    const auto k = static_cast<std::size_t>(random.whole(0, 2));
    const std::uint32_t apex = triangle[k], a = triangle[(k + 1) % 3], b = triangle[(k + 2) % 3];
    const Vec3 p = tin.vertices_m[a], q = tin.vertices_m[b];
    const std::uint32_t other = tin.neighbours[t][k];
    const bool whole = p.x == std::floor(p.x) && p.y == std::floor(p.y) && q.x == std::floor(q.x) &&
                       q.y == std::floor(q.y);
    // Beside a wall the new one might cross it; and what was split already stays as it is.
    if (!random.chance(probability) || !whole || !is_ground(t) ||
        (other != kNoTriangle && (done[other] || !is_ground(other)))) {
      triangles.push_back(triangle);
      continue;
    }
    const double by = (random.chance(0.5) ? 1 : -1) * random.between(1, 9);
    const auto m = static_cast<std::uint32_t>(tin.vertices_m.size());
    tin.vertices_m.push_back({(p.x + q.x) / 2, (p.y + q.y) / 2, (p.z + q.z) / 2 + by});
    triangles.push_back({apex, a, m});
    triangles.push_back({apex, m, b});
    if (other != kNoTriangle) triangles.push_back({b, m, a});
  }
  tin.triangles = std::move(triangles);
  tin.neighbours = neighbours_by_sorting(tin.triangles);
}

} // namespace orograph
