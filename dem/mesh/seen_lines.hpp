// SPDX-License-Identifier: GPL-3.0-or-later
// Of arranged lines, what is seen.
#pragma once

#include "dem/mesh/plan_arrangement.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace orograph {

/// An edge between faces that is on no line, where rounding led lines past each other.
constexpr std::uint32_t no_line = 0xffffffff;

/// A stretch of a line on whose two sides different triangles are the highest.
struct SeenLine {
  std::uint32_t of = 0; ///< the line, by number; or no_line
  std::vector<Vec2> points;
};

/// `highest` has a triangle for each face, or kNoTriangle. Points in a stretch's midst at which no
/// other stretch ends are left out.
std::vector<SeenLine> seen_lines(const PlanArrangement& arrangement,
                                 std::span<const std::uint32_t> highest);

} // namespace orograph
