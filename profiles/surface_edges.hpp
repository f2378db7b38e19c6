// SPDX-License-Identifier: GPL-3.0-or-later
// A surface's edges, with what is on either side of them, and as lists, in order.
#pragma once

#include "dem/surface.hpp"
#include "dem/tin.hpp"
#include "geometry/on_all_cores.hpp"
#include "profiles/outline.hpp"
#include "profiles/triangles.hpp"
#include "view/view.hpp"

#include <algorithm>
#include <cstdint>
#include <ranges>
#include <vector>

namespace orograph {

/// From the vertex of lower index to the higher, with the triangles on its left and right seen from
/// above; kNoTriangle where there is none.
struct TinEdge {
  SurfaceEdge edge;
  std::uint32_t left, right;
};

/// The edge opposite to vertex k of triangle t.
inline TinEdge edge_opposite(const Tin& tin, std::uint32_t t, std::size_t k) {
  const std::uint32_t a = tin.triangles[t][(k + 1) % 3], b = tin.triangles[t][(k + 2) % 3];
  const std::uint32_t other = tin.neighbours[t][k];
  return a < b ? TinEdge{{a, b}, t, other} : TinEdge{{b, a}, other, t};
}

/// Calls take(TinEdge) for every edge of these triangles that no triangle before them has.
template <class Triangles, class Take>
void for_each_edge(const Tin& tin, const Triangles& triangles, const Take& take) {
  for (const std::uint32_t t : triangles) {
    throw_if_stopped(t);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t other = tin.neighbours[t][k];
      if (other == kNoTriangle || t < other) take(edge_opposite(tin, t, k));
    }
  }
}
/// Calls take(TinEdge) for every edge once, triangle by triangle.
template <class Take>
void for_each_edge(const Tin& tin, const Take& take) {
  for_each_edge(
      tin, std::views::iota(std::uint32_t{0}, static_cast<std::uint32_t>(tin.triangles.size())),
      take);
}

/// The vertex of a triangle that isn't an end of the edge.
inline std::uint32_t apex_of(const Tin& tin, std::uint32_t triangle, SurfaceEdge edge) {
  for (const std::uint32_t vertex : tin.triangles[triangle])
    if (vertex != edge.from && vertex != edge.to) return vertex;
  return edge.from; // not reached: a triangle has three vertices
}

/// Bits of every triangle (profiles/facing.hpp). Cost: one pass, on all cores.
std::vector<std::uint8_t> facing_of_triangles(const Tin& tin, const View& view);

/// Vertical triangles: no area seen from above, to rounding. Empty where there are none.
TriangleSet walls_of(const Tin& tin);

/// The edges that a wall turned away from the eye hides by itself: its foot, and all below its top;
/// and vertical edges under ground that lies towards the eye. They lie where the top does, seen
/// from above, so depth doesn't tell that they are behind it. In order.
std::vector<SurfaceEdge> edges_behind_walls(const Tin& tin, const View& view);

/// All edges of the triangles that are there. Cost: one pass over the triangles.
std::vector<SurfaceEdge> edges_of(const Grid& grid);
std::vector<SurfaceEdge> edges_of(const Tin& tin);
std::vector<SurfaceEdge> edges_of(const Surface& surface);

/// The edges on whose nearer side there is ground, and on whose farther side there is a wall or
/// nothing: what else stands at their place on the ground is behind them. In order.
std::vector<SurfaceEdge> brinks(const Surface& surface, const std::vector<BorderEdge>& border,
                                const View& view);

/// The edges that a wall turned away from the eye hides by itself; a grid
/// has none.
std::vector<SurfaceEdge> edges_behind_walls(const Surface& surface, const View& view);

} // namespace orograph
