// SPDX-License-Identifier: GPL-3.0-or-later
// Finding a Tin's triangles by place.
#pragma once

#include "dem/tin.hpp"
#include "geometry/box.hpp"

#include <cstdint>
#include <vector>

namespace orograph {

/// Square buckets over the ground, about one for four triangles, each with the triangles that meet
/// it (and perhaps some that come near). Where triangles are long, buckets are larger, so that
/// there are never more than 16 entries a triangle.
class TinIndex {
public:
  /// REQUIRES that `tin` outlives the index, a triangle at least, indices in range and finite
  /// coordinates; the Tin needn't be valid otherwise. Cost O(triangles) time, on all cores, and
  /// memory, and a factor log(triangles) in time where triangles are long.
  explicit TinIndex(const Tin& tin);

  /// Triangles by number, in ascending order, each once, into `out`: all that meet `box` seen from
  /// above (touching counts), and perhaps others whose own boxes meet it.
  void meeting(const Box2& box, std::vector<std::uint32_t>& out) const;
  /// The same for a strip: all points within `slack_m` of the straight line from -> to. Triangles
  /// that only come near it may be among them. REQUIRES finite coordinates.
  void along(Vec2 from, Vec2 to, double slack_m, std::vector<std::uint32_t>& out) const;

private:
  bool count(std::size_t most);
  void lay_buckets(double bucket_m);
  int column_of(double x) const;
  int row_of(double y) const;
  Box2 box_of(std::uint32_t triangle) const;
  void append(int first, int last, int row, const Box2& box, std::vector<std::uint32_t>& out) const;
  template <class Visit>
  void for_each_run(std::uint32_t triangle, Visit visit) const;

  const Tin& tin_;
  Box2 box_;
  double bucket_m_ = 1;
  double rounding_m_ = 0; ///< of a place reckoned on an edge, at most
  int columns_ = 0, rows_ = 0;
  std::vector<std::uint32_t> begin_, triangles_; ///< of bucket i: [begin_[i], begin_[i + 1])
};

} // namespace orograph
