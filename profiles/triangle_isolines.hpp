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
#include <limits>
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

/// Levels, which rise. REQUIRES that they outlive it.
class IsolineLevels {
public:
  explicit IsolineLevels(std::span<const double> levels) : levels_(levels) {
    if (levels.size() > 1)
      per_value_ = static_cast<double>(levels.size() - 1) / (levels.back() - levels.front());
  }

  double operator[](std::int32_t i) const { return levels_[static_cast<std::size_t>(i)]; }
  LevelStanding standing_of(double value) const {
    if (std::isnan(value)) return {value, LevelStanding::kNowhere, false};
    const std::int32_t count = count_up_to(value);
    return {value, count, count > 0 && (*this)[count - 1] == value};
  }

private:
  // Levels are nearly always equally far apart: a guess is right, or next to it.
  std::int32_t count_up_to(double value) const {
    const auto size = static_cast<double>(levels_.size());
    auto guess =
        static_cast<std::size_t>(std::clamp((value - levels_.front()) * per_value_ + 1, 0.0, size));
    constexpr int kNear = 3;
    for (int i = 0; i < kNear; ++i) {
      if (guess < levels_.size() && levels_[guess] <= value)
        ++guess;
      else if (guess > 0 && levels_[guess - 1] > value)
        --guess;
      else
        return static_cast<std::int32_t>(guess);
    }
    return static_cast<std::int32_t>(std::upper_bound(levels_.begin(), levels_.end(), value) -
                                     levels_.begin());
  }

  std::span<const double> levels_;
  double per_value_ = 0;
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
inline void add_edge_points(const IsolineEnd& from, const IsolineEnd& to, const IsolineLevels& levels, std::vector<EdgePoint>& out) {
  const CrossedLevels crossed = crossed_within(from.standing, to.standing);
  for (std::int32_t i = crossed.first; i < crossed.last; ++i)
    out.push_back({{from.vertex, to.vertex},
                   (levels[i] - from.standing.value) / (to.standing.value - from.standing.value)});
}

/// A side of a triangle; `first_point`: the number of the first point within it.
struct IsolineSide {
  IsolineEnd a, b;
  std::uint32_t first_point;
};

/// Where a level that crosses a side does so.
inline std::uint32_t isoline_node_on(const IsolineSide& side, std::int32_t level) {
  const bool a_upper = side.a.standing.levels > side.b.standing.levels;
  const IsolineEnd &upper = a_upper ? side.a : side.b, &lower = a_upper ? side.b : side.a;
  if (upper.standing.on_level && level == upper.standing.levels - 1) return upper.vertex;
  return side.first_point + static_cast<std::uint32_t>(level - lower.standing.levels);
}

/// Takes the lines of a triangle, with their ends from < to.
template <class Take>
void for_each_isoline(const std::array<IsolineSide, 3>& sides, std::size_t triangle, const Take& take) {
  std::int32_t low = std::numeric_limits<std::int32_t>::max(), high = LevelStanding::kNowhere;
  for (const IsolineSide& side : sides) {
    if (!side.a.standing.is_there() || !side.b.standing.is_there()) return;
    low = std::min({low, side.a.standing.levels, side.b.standing.levels});
    high = std::max({high, side.a.standing.levels, side.b.standing.levels});
  }
  for (std::int32_t level = low; level < high; ++level) {
    std::array<std::uint32_t, 2> ends{};
    std::size_t count = 0;
    for (const IsolineSide& side : sides)
      if ((side.a.standing.levels <= level) != (side.b.standing.levels <= level))
        ends[count++] = isoline_node_on(side, level);
    if (ends[0] == ends[1]) continue; // a vertex
    const auto [from, to] = std::minmax(ends[0], ends[1]);
    take(
        Isoline{from, to, static_cast<std::uint32_t>(triangle), static_cast<std::uint32_t>(level)});
  }
}

} // namespace orograph
