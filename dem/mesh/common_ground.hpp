// SPDX-License-Identifier: GPL-3.0-or-later
// Two triangles over the same ground.
#pragma once

#include "dem/tin.hpp"

#include <array>
#include <optional>
#include <vector>

namespace orograph {

/// A point on an edge, where it pierces a triangle.
struct PiercedEdge {
  std::array<std::uint32_t, 2> edge; ///< the lower vertex first
  Vec2 at;                           ///< the same numbers whichever triangle of the edge is asked
};

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

double area_m2(const Tin& tin, std::uint32_t triangle);

} // namespace orograph
