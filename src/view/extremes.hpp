// SPDX-License-Identifier: GPL-3.0-or-later
// The greatest value of a linear-fractional function over many points, looking at few of them.
#pragma once

#include "geometry/blocked_points.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <vector>

namespace orograph {

/// Greatest value of `f(Vec3)` over all points; -infinity where there are none. On a box such a
/// function is greatest at a corner as long as its denominator is positive there, so blocks whose
/// corners stay below what was found are skipped. `f` returns +infinity where its denominator isn't
/// positive; then so does this, if that is so at a point and not only at a box's corner.
/// Cost: eight evaluations a block, and the points of a few blocks.
template <class Function>
double greatest(const BlockedPoints& blocked, const Function& f) {
  const std::size_t count = blocked.boxes.size();
  std::vector<double> bound(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Box3& box = blocked.boxes[i];
    double most = -std::numeric_limits<double>::infinity();
    for (int corner = 0; corner < 8; ++corner)
      most = std::max(
          most, f(Vec3{(corner & 1) ? box.high.x : box.low.x, (corner & 2) ? box.high.y : box.low.y,
                       (corner & 4) ? box.high.z : box.low.z}));
    bound[i] = most;
  }
  std::vector<std::size_t> heap(count);
  std::iota(heap.begin(), heap.end(), std::size_t{0});
  const auto lower = [&](std::size_t a, std::size_t b) { return bound[a] < bound[b]; };
  std::make_heap(heap.begin(), heap.end(), lower);
  double best = -std::numeric_limits<double>::infinity();
  while (!heap.empty() && bound[heap.front()] > best) {
    for (const Vec3& point : blocked.points(heap.front())) best = std::max(best, f(point));
    std::pop_heap(heap.begin(), heap.end(), lower);
    heap.pop_back();
  }
  return best;
}

} // namespace orograph
