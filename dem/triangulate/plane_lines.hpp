// SPDX-License-Identifier: GPL-3.0-or-later
// Lines in a plane triangulation, and heights where they are split.
#pragma once

#include "dem/triangulate/plane_triangulation.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace orograph {

using Edge = std::array<std::uint32_t, 2>; ///< two vertices

/// Whatever the direction: equal for an edge and its reverse.
inline std::uint64_t edge_key(std::uint32_t a, std::uint32_t b) {
  return a < b ? std::uint64_t{a} << 32U | b : std::uint64_t{b} << 32U | a;
}

/// The steps of a polyline that go anywhere.
void append_edges(std::span<const std::uint32_t> polyline, bool closed, std::vector<Edge>& edges);

/// Adds each edge once, in an order that doesn't depend on the given one; the line of each.
std::vector<std::uint32_t> add_lines(PlaneTriangulation& plane, std::span<const Edge> edges);

struct SplitHeights {
  std::uint64_t vertices = 0; ///< that got a height
  double greatest_m = 0;      ///< how far apart the lines were at one of them
};

/// A vertex without height (NaN) that splits lines gets the mean of those lines' own heights there.
/// A line's height goes evenly from its first vertex to its last. `heights_m` grows to the number
/// of places.
SplitHeights add_heights_of_lines(const PlaneTriangulation& plane,
                                  std::span<const std::uint32_t> lines,
                                  std::vector<double>& heights_m);

/// The same, where a line's height goes evenly between those of its vertices that have one; beyond
/// them it has none.
SplitHeights add_heights_between(const PlaneTriangulation& plane,
                                 std::span<const std::uint32_t> lines,
                                 std::vector<double>& heights_m);

} // namespace orograph
