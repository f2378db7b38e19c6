// SPDX-License-Identifier: GPL-3.0-or-later
// Many points in blocks with boxes, so that extremes over all are found by looking at few.
#pragma once

#include "geometry/box.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
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

} // namespace orograph
