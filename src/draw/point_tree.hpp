// SPDX-License-Identifier: GPL-3.0-or-later
// The nearest of many points, of which ever fewer are left.
#pragma once

#include "geometry/box.hpp"
#include "geometry/vec.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace orograph {

/// Points by number, halved again and again across the longer side of what holds them, so that
/// crowds and empty paper cost the same. Building costs O(n log n), each of the rest about
/// O(log n); 30 bytes a point. REQUIRES fewer than 2^31 points, all finite.
class PointTree {
public:
  explicit PointTree(std::span<const Vec2> points);

  void remove(std::uint32_t point);
  /// The nearest of those left; of several the lowest number. None where none is left.
  std::optional<std::uint32_t> nearest(Vec2 to) const;
  /// So many of those left, or all, in the same order: nearest first, then by number.
  void nearest(Vec2 to, std::size_t count, std::vector<std::uint32_t>& out) const;

private:
  struct Node {
    Box2 box;
    std::uint32_t begin, end; ///< among `entries_`
    std::uint32_t left;       ///< how many points haven't been removed
  };
  struct Entry {
    Vec2 at;
    std::uint32_t point;
    bool is_left;
  };
  struct Near {
    double squared;
    std::uint32_t point;

    bool operator<(const Near& other) const {
      return squared != other.squared ? squared < other.squared : point < other.point;
    }
  };

  void divide(std::size_t node, std::uint32_t begin, std::uint32_t end);
  void seek(std::size_t node, Vec2 to, std::size_t count, std::vector<Near>& found) const;

  std::vector<Node> nodes_; ///< of node i the halves are 2 i + 1 and 2 i + 2
  std::vector<Entry> entries_;
  std::vector<std::uint32_t> places_; ///< of each point, among `entries_`
};

} // namespace orograph
