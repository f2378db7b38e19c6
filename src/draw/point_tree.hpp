// SPDX-License-Identifier: GPL-3.0-or-later
// The nearest of many points, of which ever fewer are left.
#pragma once

#include "geometry/box.hpp"
#include "geometry/vec.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace orograph {

/// Points by number, halved again and again across the longer side of what holds them, so that
/// crowds and empty paper cost the same. Building costs O(n log n), on all cores, each of the rest
/// about O(log n); 35 bytes a point. REQUIRES fewer than 2^31 points, all finite.
class PointTree {
public:
  explicit PointTree(std::span<const Vec2> points);

  void remove(std::uint32_t point);
  /// The nearest of those left; of several the lowest number. None where none is left.
  std::optional<std::uint32_t> nearest(Vec2 to) const;
  /// The same to the place of a point, be it left or not: quicker, since what is near to it is
  /// mostly beside it in the tree.
  std::optional<std::uint32_t> nearest_to_point(std::uint32_t point) const;
  /// So many of those left, or all, in the same order: nearest first, then by number.
  void nearest(Vec2 to, std::size_t count, std::vector<std::uint32_t>& out) const;

private:
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
  struct Nearest;
  struct SomeNearest;

  std::size_t leaf_of(std::size_t entry) const { return leaves_ + entry / in_leaf_; }
  struct Half {
    std::size_t node, begin, end; ///< among `entries_`
    Box2 around;                  ///< the points, not closely
  };
  std::array<Half, 2> halves_of(const Half& whole);
  void divide(const Half& whole);
  void sum_up(std::size_t node);
  template <class Found>
  void seek(std::size_t node, Vec2 to, Found& found) const;

  // All leaves but the last have as many points. The root is node 1, the halves of node i are 2 i
  // and 2 i + 1, and leaves come last, in the order of their entries.
  std::size_t leaves_ = 1, in_leaf_ = 1;
  std::vector<Box2> boxes_;        ///< of nodes
  std::vector<std::uint8_t> left_; ///< of a leaf's points, or how many halves have any
  std::vector<Entry> entries_;
  std::vector<std::uint32_t> places_; ///< of each point, among `entries_`
};

} // namespace orograph
