// SPDX-License-Identifier: GPL-3.0-or-later
// Finding a Tin's triangles by place.
#pragma once

#include "dem/tin.hpp"
#include "geometry/box.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace orograph {

/// Square buckets over the ground, about one a triangle, each with the triangles whose boxes meet
/// it.
class TinIndex {
public:
  /// REQUIRES that `tin` outlives the index, and a triangle at least. Cost O(triangles + buckets
  /// that they meet); memory the same, 4 bytes each.
  explicit TinIndex(const Tin& tin);

  /// Triangles, each once and by number, whose boxes (seen from above) meet `box`, into `out`.
  void meeting(const Box2& box, std::vector<std::uint32_t>& out) const;
  /// The same for a strip: all points within `slack_m` of the straight line from -> to. Triangles
  /// that only come near it may be among them.
  void along(Vec2 from, Vec2 to, double slack_m, std::vector<std::uint32_t>& out) const;

private:
  const Tin& tin_;
  Box2 box_;
  double bucket_m_ = 1;
  int columns_ = 0, rows_ = 0;
  std::vector<std::uint32_t> begin_, triangles_; ///< of bucket i: [begin_[i], begin_[i + 1])
};

} // namespace orograph
