// SPDX-License-Identifier: GPL-3.0-or-later
// Many points in blocks with boxes, so that extremes over all are found by looking at few.
#pragma once

#include "geometry/box.hpp"

#include <functional>
#include <span>
#include <vector>

namespace orograph {

struct BlockedPoints {
  std::vector<Box3> boxes; ///< of each block's points; blocks without points have no box here
  /// The points of block i; the span is valid until the next call.
  std::function<std::span<const Vec3>(std::size_t)> points;
};

} // namespace orograph
