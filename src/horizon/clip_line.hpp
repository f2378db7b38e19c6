// SPDX-License-Identifier: GPL-3.0-or-later
// Which parts of one straight line are above a horizon that it doesn't change.
#pragma once

#include "geometry/vec.hpp"
#include "horizon/horizon.hpp"

#include <vector>

namespace orograph {

/// A part of a line between two shares of the way from its first end to its second.
struct LinePart {
  double begin, end;
};

/// The parts of the line from a to b, in any direction, that lie above the horizon, compared
/// exactly, in order from a to b; appended to `out`. A line with no extent in X is clipped along Y
/// against the higher of the horizon's heights at its X. Cost O(log of the horizon + pieces met).
void clip_line(Vec2 a, Vec2 b, const Horizon& horizon, std::vector<LinePart>& out);

} // namespace orograph
