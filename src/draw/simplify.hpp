// SPDX-License-Identifier: GPL-3.0-or-later
// Leaving out points of a polyline that nobody would miss.
#pragma once

#include "geometry/vec.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace orograph {

/// Indices, rising, of the points to keep: the first, the last, and as many between that the
/// polyline through them and the one through all points are nowhere farther apart than `tolerance`
/// (Hausdorff distance). Zero or less keeps all. Written to `kept`.
///
/// From each kept point the next one is taken as far on as a straight line reaches that passes all
/// points between within the tolerance and ends no nearer to its start than any of them. That
/// bounds each left-out point's distance to the new line's segment, hence (distance to a segment is
/// convex) every point of the old polyline's; and the old polyline, going from one end of the new
/// segment to the other, passes all of it within the same bound.
/// Cost O(points): 3 to 5 ns a point. REQUIRES numbers whose fourth powers neither overflow nor
/// vanish, such as a page's.
void simplify(std::span<const Vec2> points, double tolerance, std::vector<std::uint32_t>& kept);

} // namespace orograph
