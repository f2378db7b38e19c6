// SPDX-License-Identifier: GPL-3.0-or-later
// Where levels of a value cross a triangle and its edges: the rule that all isolines are made by
// (profiles/isolines.hpp).
#pragma once

#include "profiles/isolines.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace orograph {

/// Of a vertex: its value, and how many levels aren't above that.
struct LevelStanding {
  double value;
  std::int32_t levels; // kNowhere where there is no vertex
  bool on_level;       // the last of those is its value

  static constexpr std::int32_t kNowhere = -1;
  bool is_there() const { return levels != kNowhere; }
};

/// Levels, which rise.
class IsolineLevels {
public:
  explicit IsolineLevels(std::span<const double> levels)
      : count_(static_cast<double>(levels.size())) {
    bounds_.push_back(-kInfinity);
    bounds_.insert(bounds_.end(), levels.begin(), levels.end());
    bounds_.push_back(kInfinity);
    if (levels.empty()) return;
    first_ = levels.front();
    if (levels.size() > 1) per_value_ = (count_ - 1) / (levels.back() - first_);
    rounding_ = 0;
    for (std::size_t i = 0; i < levels.size(); ++i)
      rounding_ = std::max(rounding_, std::abs(place_of(levels[i]) - static_cast<double>(i + 1)));
  }

  double operator[](std::int32_t i) const { return bounds_[static_cast<std::size_t>(i) + 1]; }
  /// How many aren't above a value; kNowhere of NaN. They are nearly always equally far apart: a
  /// guess is right.
  std::int32_t count_up_to(double value) const {
    const auto guess = static_cast<std::size_t>(std::max(0.0, std::min(count_, place_of(value))));
    return bounds_[guess] <= value && value < bounds_[guess + 1] ? static_cast<std::int32_t>(guess)
                                                                 : search(value);
  }
  bool is_level(std::int32_t count, double value) const {
    return count > 0 && bounds_[static_cast<std::size_t>(count)] == value;
  }
  LevelStanding standing_of(double value) const {
    const std::int32_t count = count_up_to(value);
    return {value, count, is_level(count, value)};
  }
  /// The counts of many values; `near` gets the numbers of those that may be on a level, or aren't
  /// there, whose counts may be wrong.
  void count_most(std::span<const double> values, std::span<std::int32_t> counts,
                  std::vector<std::uint32_t>& near) const {
    near.clear();
    const double first = first_, per_value = per_value_, most = count_ + 0.5;
    // Nearly all are farther from the place of any level than levels are from theirs. A loop that
    // the compiler turns into vector instructions, and one that it doesn't.
    constexpr std::size_t kBatch = 256;
    std::array<double, kBatch> shares;
    for (std::size_t begin = 0; begin < values.size(); begin += kBatch) {
      const double* const of = values.data() + begin;
      std::int32_t* const to = counts.data() + begin;
      const int some = static_cast<int>(std::min(kBatch, values.size() - begin));
      for (int i = 0; i < some; ++i) {
        const double place = (of[i] - first) * per_value + 1;
        const double within = place > 0.5 ? (place < most ? place : most) : 0.5;
        to[i] = static_cast<std::int32_t>(within);
        shares[static_cast<std::size_t>(i)] = std::isnan(place) ? 0.0 : within - to[i];
      }
      for (int i = 0; i < some; ++i) {
        const double share = shares[static_cast<std::size_t>(i)];
        if (!(share > rounding_ && share < 1 - rounding_))
          near.push_back(static_cast<std::uint32_t>(begin) + static_cast<std::uint32_t>(i));
      }
    }
  }

private:
  // Whole numbers at the levels, to rounding, where those are equally far apart. It never falls.
  double place_of(double value) const { return (value - first_) * per_value_ + 1; }
  std::int32_t search(double value) const {
    if (std::isnan(value)) return LevelStanding::kNowhere;
    return static_cast<std::int32_t>(
        std::upper_bound(bounds_.begin() + 1, bounds_.end() - 1, value) - bounds_.begin() - 1);
  }

  std::vector<double> bounds_; ///< the levels, between infinities
  double count_, first_ = 0, per_value_ = 0;
  double rounding_ = kInfinity; ///< of a level's place
};

/// An end of an edge, with its number.
struct IsolineEnd {
  std::uint32_t vertex;
  LevelStanding standing;
};

/// Which levels cross an edge within it: [first, last). One that its upper end is on goes through
/// that vertex.
struct CrossedLevels {
  std::int32_t first = 0, last = 0;
  std::uint32_t count() const { return static_cast<std::uint32_t>(last - first); }
};
inline CrossedLevels crossed_within(const LevelStanding& a, const LevelStanding& b) {
  if (!a.is_there() || !b.is_there() || a.levels == b.levels) return {};
  const bool a_upper = a.levels > b.levels;
  const LevelStanding &upper = a_upper ? a : b, &lower = a_upper ? b : a;
  return {lower.levels, upper.levels - (upper.on_level ? 1 : 0)};
}

/// Adds them, rising. REQUIRES from.vertex < to.vertex.
inline void add_edge_points(const IsolineEnd& from, const IsolineEnd& to,
                            const IsolineLevels& levels, std::vector<EdgePoint>& out) {
  const CrossedLevels crossed = crossed_within(from.standing, to.standing);
  for (std::int32_t i = crossed.first; i < crossed.last; ++i)
    out.push_back({{from.vertex, to.vertex},
                   (levels[i] - from.standing.value) / (to.standing.value - from.standing.value)});
}

/// A triangle, and on the side opposite to each of its corners the number of the first point within
/// it.
struct IsolineTriangle {
  std::array<IsolineEnd, 3> corners;
  std::array<std::uint32_t, 3> first_points;
};

/// Where a level that crosses a side does so.
inline std::uint32_t isoline_node_on(const IsolineEnd& upper, const IsolineEnd& lower,
                                     std::uint32_t first_point, std::int32_t level) {
  if (upper.standing.on_level && level == upper.standing.levels - 1) return upper.vertex;
  return first_point + static_cast<std::uint32_t>(level - lower.standing.levels);
}

/// Takes the lines of a triangle, with their ends from < to.
template <class Take>
void for_each_isoline(const IsolineTriangle& triangle, std::size_t number, const Take& take) {
  const auto& [a, b, c] = triangle.corners;
  const auto [low, high] = std::minmax({a.standing.levels, b.standing.levels, c.standing.levels});
  if (low == LevelStanding::kNowhere) return;
  for (std::int32_t level = low; level < high; ++level) {
    const auto is_above = [&](const IsolineEnd& corner) { return corner.standing.levels > level; };
    // The corner that is on a side of its own: both sides that meet there are crossed.
    const std::size_t alone = is_above(a) == is_above(b) ? 2 : is_above(b) == is_above(c) ? 0 : 1;
    const std::size_t next = (alone + 1) % 3, last = (alone + 2) % 3;
    const IsolineEnd& corner = triangle.corners[alone];
    const auto node = [&](std::size_t other, std::size_t opposite) {
      const IsolineEnd& end = triangle.corners[other];
      return is_above(corner)
                 ? isoline_node_on(corner, end, triangle.first_points[opposite], level)
                 : isoline_node_on(end, corner, triangle.first_points[opposite], level);
    };
    const std::uint32_t one = node(next, last), other = node(last, next);
    if (one == other) continue; // a vertex
    take(Isoline{std::min(one, other), std::max(one, other), static_cast<std::uint32_t>(number),
                 static_cast<std::uint32_t>(level)});
  }
}

} // namespace orograph
