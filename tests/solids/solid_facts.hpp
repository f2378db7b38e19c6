// SPDX-License-Identifier: GPL-3.0-or-later
// What holds of every solid, and what can be counted on it.
#pragma once

#include "solids/solid.hpp"
#include "tests/catch.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace orograph {

inline double volume_of(const Solid& solid) {
  double six = 0;
  for (const auto& [a, b, c] : solid.triangles)
    six += dot(solid.vertices_m[a], cross(solid.vertices_m[b], solid.vertices_m[c]));
  return six / 6;
}

/// V - E + F: 2 for a ball, 0 for a ring.
inline long euler_of(const Solid& solid) {
  return static_cast<long>(solid.vertices_m.size()) - static_cast<long>(solid.edges.size()) +
         static_cast<long>(solid.triangles.size());
}

inline std::size_t drawn_edges(const Solid& solid) {
  return static_cast<std::size_t>(std::count_if(solid.edges.begin(), solid.edges.end(),
                                                [](const SolidEdge& e) { return !e.smooth; }));
}

inline bool runs_along(const std::array<std::uint32_t, 3>& triangle, std::uint32_t from,
                       std::uint32_t to) {
  for (int i = 0; i < 3; ++i)
    if (triangle[i] == from && triangle[(i + 1) % 3] == to) return true;
  return false;
}

/// Each edge between its two triangles, each triangle's sides all there, and no edge twice.
inline void require_closed(const Solid& solid) {
  REQUIRE(3 * solid.triangles.size() == 2 * solid.edges.size());
  for (const SolidEdge& edge : solid.edges) {
    REQUIRE(!edge.is_wire());
    REQUIRE(runs_along(solid.triangles[edge.left], edge.from, edge.to));
    REQUIRE(runs_along(solid.triangles[edge.right], edge.to, edge.from));
  }
  std::vector<std::array<std::uint32_t, 3>> sides; // with the triangle: a side is found once
  for (const SolidEdge& edge : solid.edges) {
    sides.push_back({edge.from, edge.to, edge.left});
    sides.push_back({edge.to, edge.from, edge.right});
  }
  std::sort(sides.begin(), sides.end());
  REQUIRE(std::adjacent_find(sides.begin(), sides.end()) == sides.end());
  REQUIRE(volume_of(solid) > 0);
}

} // namespace orograph
