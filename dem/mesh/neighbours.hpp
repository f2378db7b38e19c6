// SPDX-License-Identifier: GPL-3.0-or-later
// Which triangles lie side by side, and along which edges.
#pragma once

#include "dem/tin.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace orograph {

/// The edge of a triangle that is opposite to its vertex `side`.
struct TriangleSide {
  std::uint32_t triangle = 0, side = 0;
  bool operator==(const TriangleSide&) const = default;
};

struct Neighbours {
  /// [t][k]: the triangle on the other side of the edge opposite to vertex k of t, whichever way
  /// the two run along it; kNoTriangle where there is none, or where the edge is crowded.
  std::vector<std::array<std::uint32_t, 3>> of;
  /// Edges with more than two triangles, each with all its sides by number of the triangle.
  std::vector<std::vector<TriangleSide>> crowded;
};

/// REQUIRES triangles of three different vertices, all below `vertices`, and no more than a third
/// of what 32 bits count. An edge is its two vertices' indices. Cost O(triangles + vertices), and a
/// sort at each vertex, on all cores.
Neighbours find_neighbours(std::span<const std::array<std::uint32_t, 3>> triangles,
                           std::size_t vertices);

/// The vertices at the ends of a side, in the triangle's own direction.
inline std::array<std::uint32_t, 2> ends_of(const std::array<std::uint32_t, 3>& triangle,
                                            std::uint32_t side) {
  return {triangle[(side + 1) % 3], triangle[(side + 2) % 3]};
}

using PlanEdge = std::array<std::uint32_t, 2>; ///< two vertices, the lower one first

/// The edge of a triangle that is opposite to its vertex `side`.
inline PlanEdge edge_of(const std::array<std::uint32_t, 3>& triangle, std::uint32_t side) {
  const auto [a, b] = ends_of(triangle, side);
  return a < b ? PlanEdge{a, b} : PlanEdge{b, a};
}

/// The two run the same way along the edge opposite to vertex `side` of a. REQUIRES that they are
/// neighbours there.
bool run_alike(const Tin& tin, std::uint32_t a, std::uint32_t side, std::uint32_t b);

} // namespace orograph
