// SPDX-License-Identifier: GPL-3.0-or-later
// Many points in blocks with boxes, so that the extremes of linear-fractional functions over all of
// them are found by looking at few.
#pragma once

#include "geometry/box.hpp"
#include "geometry/on_all_cores.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <vector>

namespace orograph {

/// Neighbouring blocks, and the box of them all.
struct BlockGroup {
  Box3 box;
  std::vector<std::uint32_t> blocks;

  void add(std::size_t block, const Box3& of_block) {
    box.include(of_block.low);
    box.include(of_block.high);
    blocks.push_back(static_cast<std::uint32_t>(block));
  }
};

struct BlockedPoints {
  std::vector<Box3> boxes; ///< of each block's points; blocks without points have no box here
  /// Each block is in one of these, some 64 together; or there are no groups.
  std::vector<BlockGroup> groups;
  /// The points of block i; the span is valid until the next call.
  std::function<std::span<const Vec3>(std::size_t)> points;
};

/// A value of a function over points, and the point that has it.
struct Extreme {
  double value = -std::numeric_limits<double>::infinity();
  Vec3 at;

  template <class Function>
  void take(const Function& f, Vec3 point) {
    if (const double there = f(point); there > value) *this = {there, point};
  }
};

/// Of several points that lie close together; a box of them is bounded before they are looked at.
constexpr std::size_t kPointsBounded = 64;

/// Takes those points of a block that may be greater than what was found, with a bound as
/// `greatest` has it.
template <class Function, class Bound>
void take_greatest(std::span<const Vec3> points, const Function& f, const Bound& bound_of,
                   Extreme& best) {
  for (; !points.empty(); points = points.subspan(std::min(kPointsBounded, points.size()))) {
    const auto some = points.first(std::min(kPointsBounded, points.size()));
    Box3 box;
    for (const Vec3& point : some) box.include(point);
    if (!(bound_of(box, best.value) > best.value)) continue;
    for (const Vec3& point : some) best.take(f, point);
  }
}

/// Greatest value of `f(Vec3)` over all points; -infinity where there are none. `bound_of(Box3,
/// found)` is no less than `f` anywhere in a box, or no more than `found`, if all of `f` is that:
/// groups and blocks whose bound stays below what was found are skipped. `best` is to start with
/// the value at one of the points, if one is known that is likely to be nearly the greatest. Cost:
/// a bound a group and for the blocks of a few groups, and the points of a few blocks.
template <class Function, class Bound>
Extreme greatest(const BlockedPoints& blocked, const Function& f, const Bound& bound_of,
                 Extreme best) {
  struct Part {
    double bound;
    std::uint32_t index;
    bool group;
  };
  std::vector<Part> heap;
  const auto lower = [](const Part& a, const Part& b) { return a.bound < b.bound; };
  const auto add = [&](const Box3& box, std::size_t index, bool group) {
    const double bound = bound_of(box, best.value);
    if (!(bound > best.value)) return;
    heap.push_back({bound, static_cast<std::uint32_t>(index), group});
    std::push_heap(heap.begin(), heap.end(), lower);
  };
  const auto& [boxes, groups, points] = blocked;
  for (std::size_t i = 0; i < groups.size(); ++i) add(groups[i].box, i, true);
  if (groups.empty())
    for (std::size_t i = 0; i < boxes.size(); ++i) add(boxes[i], i, false);
  while (!heap.empty() && heap.front().bound > best.value) {
    throw_if_stopped();
    const Part part = heap.front();
    std::pop_heap(heap.begin(), heap.end(), lower);
    heap.pop_back();
    if (part.group) {
      for (const std::uint32_t block : groups[part.index].blocks) add(boxes[block], block, false);
    } else {
      take_greatest(points(part.index), f, bound_of, best);
    }
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
  const auto at_corners = [&](const Box3& box, double) {
    double most = -std::numeric_limits<double>::infinity();
    for (int i = 0; i < 8; ++i) most = std::max(most, f(corner_of(box, i)));
    return most;
  };
  return greatest(blocked, f, at_corners, {}).value;
}

} // namespace orograph
