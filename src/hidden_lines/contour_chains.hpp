// SPDX-License-Identifier: GPL-3.0-or-later
// Contours as far as they are visible, chained while they are found.
#pragma once

#include "geometry/profile_point.hpp"

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace orograph {

/// Where a contour meets an edge or a vertex of a grid: its level, and a number of that edge or
/// vertex. The end of a part that isn't visible beyond it is at no such node.
class ContourNode {
public:
  ContourNode(std::uint32_t level, std::uint64_t number)
      : level_and_number_((std::uint64_t{level} << kNumberBits) | number) {}
  static ContourNode loose(std::uint32_t level) { return {level, kLoose}; }

  std::uint32_t level() const {
    return static_cast<std::uint32_t>(level_and_number_ >> kNumberBits);
  }
  std::uint64_t number() const { return level_and_number_ & kLoose; }
  bool is_loose() const { return number() == kLoose; }
  auto operator<=>(const ContourNode&) const = default;

private:
  static constexpr unsigned kNumberBits = 40;
  static constexpr std::uint64_t kLoose = (std::uint64_t{1} << kNumberBits) - 1;
  std::uint64_t level_and_number_;
};

struct ContourPoint {
  ContourNode node;
  ProfilePoint at;
};

/// A piece of a contour, or a part of it: shares of the way from `from`, the node of lower number.
struct ContourPart {
  ContourPoint from, to;
  double t_begin, t_end;
};

/// Stretches of contours, each of one level and at least two points.
struct ContourRuns {
  struct Run {
    std::uint32_t end; ///< among the points
    std::uint32_t level;
  };
  std::vector<ContourPoint> points;
  std::vector<Run> runs;

  /// What was added to the points since the last one.
  void end_run() {
    runs.push_back({static_cast<std::uint32_t>(points.size()), points.back().node.level()});
  }
};

/// Chains pieces while they are found; what was added lately alone, so that it is in the cache.
/// What of a contour isn't in one run has the same node at the ends of two.
class ContourChains {
public:
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  /// Whether a point may still be linked.
  bool has(std::uint32_t number) const { return number != kNone && number >= first_; }
  /// Adds a point, and tells its number.
  std::uint32_t add(const ContourPoint& point) {
    points_.push_back(point);
    beside_.push_back({kNone, kNone});
    return first_ + static_cast<std::uint32_t>(points_.size() - 1);
  }
  /// A visible piece from point to point. REQUIRES that each has less than two.
  void link(std::uint32_t a, std::uint32_t b) {
    for (const auto& [of, to] : {std::array{a, b}, {b, a}}) {
      auto& beside = beside_[of - first_];
      beside[beside[0] == kNone ? 0 : 1] = to - first_;
    }
  }
  /// Whether so many were added that they had better be brought into runs.
  bool is_full() const { return points_.size() >= kMost; }
  /// Forgets the points, which are in runs now.
  void end_runs();

  std::vector<ContourRuns>& runs() { return runs_; }

private:
  // An eighth of a megabyte with what they are linked to: it stays in the nearer cache.
  static constexpr std::size_t kMost = std::size_t{1} << 12U;
  using Beside = std::array<std::uint32_t, 2>;
  void walk(std::uint32_t first, std::vector<bool>& taken, ContourRuns& out) const;

  std::vector<ContourPoint> points_;
  // What points are linked to. Apart from them it stays in the cache while it is followed.
  std::vector<Beside> beside_;
  std::uint32_t first_ = 0; // number
  std::vector<ContourRuns> runs_;
};

/// What several strips of X have found, as one.
struct SeenContours {
  struct Run {
    std::uint32_t runs; ///< number
    std::uint32_t begin, end;
    std::uint32_t level;
  };
  std::vector<ContourRuns> runs;
  std::vector<Run> by_level;

  std::span<const ContourPoint> points(const Run& run) const {
    return std::span(runs[run.runs].points).subspan(run.begin, run.end - run.begin);
  }
};

/// `parts`: what isn't visible from node to node in one strip; those of a piece that overlap or
/// meet become one.
SeenContours seen_contours(std::vector<ContourRuns> runs, std::vector<ContourPart> parts);

} // namespace orograph
