// SPDX-License-Identifier: GPL-3.0-or-later
// Triangles as plain points, for tests by definition.
#pragma once

#include "dem/tin.hpp"
#include "tests/support/made_grid.hpp"

#include <array>
#include <vector>

namespace orograph {

using Corners = std::array<Vec3, 3>;

inline Vec2 ground(Vec3 v) {
  return {v.x, v.y};
}

inline double twice_area_m2(const Corners& t) {
  return cross(ground(t[1]) - ground(t[0]), ground(t[2]) - ground(t[0]));
}

inline std::vector<Corners> corners_of(const Grid& grid) {
  std::vector<Corners> all;
  for (const GridTriangle& triangle : triangles_of(grid))
    all.push_back({vertex_m(grid, triangle.vertices[0]), vertex_m(grid, triangle.vertices[1]),
                   vertex_m(grid, triangle.vertices[2])});
  return all;
}

inline std::vector<Corners> corners_of(const Tin& tin) {
  std::vector<Corners> all;
  for (const auto& [a, b, c] : tin.triangles)
    all.push_back({tin.vertices_m[a], tin.vertices_m[b], tin.vertices_m[c]});
  return all;
}

/// Neighbours by definition: every pair of triangles is looked at, and [t][k] is the one that has
/// both ends of the edge opposite to vertex k.
inline std::vector<std::array<std::uint32_t, 3>> neighbours_by_pairs(const Tin& tin) {
  std::vector<std::array<std::uint32_t, 3>> all(tin.triangles.size(),
                                                {kNoTriangle, kNoTriangle, kNoTriangle});
  const auto has = [](const std::array<std::uint32_t, 3>& triangle, std::uint32_t vertex) {
    return triangle[0] == vertex || triangle[1] == vertex || triangle[2] == vertex;
  };
  for (std::uint32_t t = 0; t < tin.triangles.size(); ++t)
    for (std::uint32_t u = 0; u < tin.triangles.size(); ++u)
      for (std::size_t k = 0; k < 3 && t != u; ++k)
        if (has(tin.triangles[u], tin.triangles[t][(k + 1) % 3]) &&
            has(tin.triangles[u], tin.triangles[t][(k + 2) % 3]))
          all[t][k] = u;
  return all;
}

/// A grid that lies turned, sheared, far away or the other way round, with holes or without, of
/// whole, equal or any heights, in float or double.
inline Grid any_small_grid(Random& random, int most) {
  GridLattice lattice =
      turned_lattice(random.whole(2, most), random.whole(2, most), {10, 13},
                     random.pick({0.0, random.between(-3, 3)}), random.pick({0.0, 0.4}));
  if (random.chance(0.3)) lattice.row_step_m = -1 * lattice.row_step_m;
  const double offset = random.pick({0.0, 1e3, 1e6});
  lattice.first_vertex_m = {random.between(-offset, offset), random.between(-offset, offset)};
  GridHeights heights;
  heights.high = random.pick({0.5, 4.0, 100.0});
  heights.missing = random.pick({0.0, 0.03, 0.15, 0.4, 1.0});
  heights.whole = random.chance(0.4);
  heights.in_double = random.chance(0.5);
  return made_grid(random, lattice, heights);
}

} // namespace orograph
