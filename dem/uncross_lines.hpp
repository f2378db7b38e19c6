// SPDX-License-Identifier: GPL-3.0-or-later
// Lines of the plane, bent so that they cross at points of theirs only.
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

/// Where two steps cross each other's insides both are led through a point there: one that is
/// there already within `reach_m`, or else the crossing, rounded. Steps that are left may touch
/// others or run along them, but none crosses another, exactly. A step not much longer than
/// `reach_m` is left out where nothing else helps; its line has a gap there.
///
/// Always comes to an end: what a step is replaced by is shorter than it, and new points keep
/// `reach_m` apart. REQUIRES finite coordinates, reach_m > 0 and some hundred times the rounding of
/// coordinates.
UncrossedLines uncross(std::span<const std::vector<Vec2>> lines, double reach_m);

} // namespace orograph
