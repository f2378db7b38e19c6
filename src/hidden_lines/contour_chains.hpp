// SPDX-License-Identifier: GPL-3.0-or-later
// Contours as far as they are visible, chained while they are found.
#pragma once

#include "geometry/profile_point.hpp"

#include <array>
#include <compare>
#include <cstdint>
#include <limits>
#include <vector>

namespace orograph {

/// Where a contour meets an edge or a vertex of a grid: its level, and a number of that edge or
/// vertex. The end of a part that isn't visible beyond it is at no such node.
class ContourNode {
public:
  ContourNode(std::uint32_t level, std::uint64_t number)
      : level_and_number_((std::uint64_t{level} << kNumberBits) | number) {}
  static ContourNode loose(std::uint32_t level) { return {level, kLoose}; }

  std::uint32_t level() const { return static_cast<std::uint32_t>(level_and_number_ >> kNumberBits); }
  std::uint64_t number() const { return level_and_number_ & kLoose; }
  bool is_loose() const { return number() == kLoose; }
  auto operator<=>(const ContourNode&) const = default;

private:
  static constexpr unsigned kNumberBits = 40;
  static constexpr std::uint64_t kLoose = (std::uint64_t{1} << kNumberBits) - 1;
  std::uint64_t level_and_number_;
};

/// A piece of a contour, or a part of it: shares of the way from `from`, the node of lower number.
struct ContourPart {
  ContourNode from, to;
  ProfilePoint at_from, at_to;
  double t_begin, t_end;
};

/// Points of contours, of which each knows those beside it. Memory: 40 bytes a point.
class ContourChains {
public:
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  struct Point {
    ProfilePoint at;
    ContourNode node;
    std::array<std::uint32_t, 2> beside{kNone, kNone};
  };

  /// Adds a point, and tells its number.
  std::uint32_t add(ContourNode node, ProfilePoint at) {
    points_.push_back({at, node});
    return static_cast<std::uint32_t>(points_.size() - 1);
  }
  /// A visible piece from point to point. REQUIRES that each has less than two.
  void link(std::uint32_t a, std::uint32_t b) {
    for (const auto& [of, to] : {std::array{a, b}, {b, a}})
      points_[of].beside[points_[of].beside[0] == kNone ? 0 : 1] = to;
  }

  const Point& point(std::uint32_t number) const { return points_[number]; }
  /// The point that a way goes on to which came from another one; kNone at its end.
  std::uint32_t next(std::uint32_t here, std::uint32_t last) const {
    const auto& beside = points_[here].beside;
    return beside[beside[0] == last ? 1 : 0];
  }

  /// From end to end; of a ring from a point to that same point.
  struct Run {
    std::uint32_t first, last;
  };
  /// All that the points are, in order of their lower end. Cost: one walk along them.
  std::vector<Run> runs() const;

private:
  std::vector<Point> points_;
};

/// What several strips of X have found, as one.
struct SeenContours {
  struct Run {
    std::uint32_t chains; ///< number
    ContourChains::Run ends;
  };
  std::vector<ContourChains> chains;
  std::vector<Run> runs; ///< by level
  /// The level of a run, and where its runs end, from number `first` on.
  std::uint32_t level(const Run& run) const {
    return chains[run.chains].point(run.ends.first).node.level();
  }
};

/// `parts`: what isn't visible from node to node in one strip; those of a piece that overlap or meet
/// become one.
SeenContours seen_contours(std::vector<ContourChains> chains, std::vector<ContourPart> parts);

} // namespace orograph
