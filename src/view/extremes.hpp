// SPDX-License-Identifier: GPL-3.0-or-later
// The greatest value of a linear-fractional function over many points, looking at few of them.
#pragma once

#include "geometry/blocked_points.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <vector>

namespace orograph {

/// Greatest value of `f(Vec3)` over all points; -infinity where there are none. `bound(Box3)` is no
/// less than `f` anywhere in a box: blocks whose bound stays below what was found are skipped.
/// Cost: a bound a block, and the points of a few blocks.
template <class Function, class Bound>
double greatest(const BlockedPoints& blocked, const Function& f, const Bound& bound_of) {
  const std::size_t count = blocked.boxes.size();
  std::vector<double> bound(count);
  for (std::size_t i = 0; i < count; ++i) bound[i] = bound_of(blocked.boxes[i]);
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

/// Corner `i` of a box, from 0 to 7.
inline Vec3 corner_of(const Box3& box, int i) {
  return {(i & 1) ? box.high.x : box.low.x, (i & 2) ? box.high.y : box.low.y,
          (i & 4) ? box.high.z : box.low.z};
}

/// The same for a linear-fractional `f`, which is greatest at a box's corner as long as its
/// denominator is positive there. `f` returns +infinity where its denominator isn't positive; then
/// so does this, if that is so at a point and not only at a box's corner.
template <class Function>
double greatest(const BlockedPoints& blocked, const Function& f) {
  return greatest(blocked, f, [&](const Box3& box) {
    double most = -std::numeric_limits<double>::infinity();
    for (int i = 0; i < 8; ++i) most = std::max(most, f(corner_of(box, i)));
    return most;
  });
}

} // namespace orograph
