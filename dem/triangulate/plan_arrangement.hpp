// SPDX-License-Identifier: GPL-3.0-or-later
// Lines of the plane, bent so that they cross at points of theirs only, and the triangulation that
// has them all as edges.
#pragma once

#include "geometry/vec.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace orograph {

using Step = std::array<std::uint32_t, 2>; ///< straight from a point to another, by number

struct UncrossedLines {
  std::vector<Vec2> points;             ///< all different
  std::vector<std::vector<Step>> lines; ///< for each given line its steps, from first to last
};

/// A step that runs within `reach_m` of a point is led through it, and where two steps cross each
/// other's insides both are led through a point there: one that is there already within reach, or
/// else the crossing, rounded. `fixed` points are there from the beginning, each in its place; the
/// lines' points are led to ones within reach like crossings. So lines that are nearly on one
/// another become one. Steps that are left may touch others or run along them, but none crosses
/// another, exactly. A step not much longer than the reach is left out where nothing else helps;
/// its line has a gap there.
///
/// Always comes to an end: what a step is replaced by is shorter than it, and new points keep
/// `reach_m` apart. REQUIRES finite coordinates, and a reach of some ten times the rounding of
/// the largest.
UncrossedLines uncross(std::span<const std::vector<Vec2>> lines, std::span<const Vec2> fixed,
                       double reach_m);

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
