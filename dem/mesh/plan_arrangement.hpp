// SPDX-License-Identifier: GPL-3.0-or-later
// Lines of the plane, brought to a triangulation that has them all as edges.
#pragma once

#include "geometry/vec.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace orograph {

struct PlanArrangement {
  std::vector<Vec2> points;
  /// Counterclockwise, exactly; no two overlap. They fill the lines' convex hull.
  std::vector<std::array<std::uint32_t, 3>> faces;
  /// For each given line the points that it goes through now, from its first to its last.
  std::vector<std::vector<std::uint32_t>> lines;
};

/// Points where lines cross are rounded to doubles, and the lines bend to go through them, or
/// through points that are there already within `reach_m` (`uncross` says how). `fixed` points stay
/// where they are.
PlanArrangement arrange(std::span<const std::vector<Vec2>> lines, std::span<const Vec2> fixed,
                        double reach_m);

} // namespace orograph
