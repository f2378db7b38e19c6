// SPDX-License-Identifier: GPL-3.0-or-later
// Triangles that share ground: which do, and how they lie over it.
#pragma once

#include "dem/tin.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace orograph {

using TrianglePair = std::array<std::uint32_t, 2>; ///< by number, the lower one first

/// The insides of two triangles meet, seen from above. Exact. REQUIRES that both run
/// counterclockwise.
bool overlap(const Tin& tin, std::uint32_t a, std::uint32_t b);

/// Two triangles that overlap, if any do; walls never do. REQUIRES finite coordinates; triangles
/// that are counterclockwise or walls; the right neighbours, running along edges the other way.
std::optional<TrianglePair> first_overlap(const Tin& tin);

/// Every pair of triangles that overlap. REQUIRES finite coordinates, and triangles that are
/// counterclockwise or walls; doesn't look at neighbours.
std::vector<TrianglePair> all_overlaps(const Tin& tin);

/// A point on an edge, where it pierces a triangle.
struct PiercedEdge {
  std::array<std::uint32_t, 2> edge; ///< the lower vertex first
  Vec2 at;                           ///< the same numbers whichever triangle of the edge is asked
};

/// What two triangles have in common.
struct CommonGround {
  double area_m2 = 0;
  /// The least and the greatest height of a above b there.
  double least_m = 0, greatest_m = 0;
  /// Where neither is above the other throughout: the line, seen from above, along which they
  /// pierce each other.
  std::optional<std::array<Vec2, 2>> pierce;
  std::vector<PiercedEdge> pierced; ///< edges that the line's ends are on; not vertices
};

/// Rounded: heights that differ by up to `tolerance_m` are taken for equal. REQUIRES triangles that
/// run counterclockwise and overlap.
CommonGround common_ground(const Tin& tin, std::uint32_t a, std::uint32_t b, double tolerance_m);

/// Height of the triangle's plane at a point seen from above, rounded. REQUIRES a triangle that
/// isn't vertical.
double height_on(const Tin& tin, std::uint32_t triangle, Vec2 at);

/// Of the triangle, seen from above.
double area_m2(const Tin& tin, std::uint32_t triangle);

} // namespace orograph
