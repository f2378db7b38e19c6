// SPDX-License-Identifier: GPL-3.0-or-later
// Finding segments of the plane by place, while more are added.
#pragma once

#include "geometry/box.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace orograph {

/// Square buckets over the ground of some lines, about one for each of their segments. A segment
/// may be a single point.
class SegmentBuckets {
public:
  /// REQUIRES reach_m > 0, some times the rounding of coordinates at least.
  SegmentBuckets(std::span<const std::vector<Vec2>> lines, double reach_m);

  void add(std::uint32_t segment, Vec2 from, Vec2 to);
  /// All segments within reach of the one given, and others near it, each once, in ascending
  /// order.
  void near(Vec2 from, Vec2 to, std::vector<std::uint32_t>& out) const;

private:
  template <class Visit>
  void for_each_bucket(Vec2 from, Vec2 to, Visit visit) const;

  Box2 box_;
  double bucket_m_ = 1, slack_m_ = 0;
  int columns_ = 1, rows_ = 1;
  std::vector<std::vector<std::uint32_t>> buckets_;
};

} // namespace orograph
