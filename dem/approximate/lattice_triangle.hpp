// SPDX-License-Identifier: GPL-3.0-or-later
// Triangles and edges between vertices of a grid: what they cover and cross, and their heights
// there.
#pragma once

#include "dem/grid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <utility>
#include <vector>

namespace orograph {

/// A vertex of a grid.
struct LatticePoint {
  int column = 0, row = 0;
  bool operator==(const LatticePoint&) const = default;
};

/// Twice the area of a, b, c as if cells were squares of side 1, x the column and y the row;
/// positive where they run counterclockwise with y up. REQUIRES columns and rows below 2^30.
inline std::int64_t twice_area(LatticePoint a, LatticePoint b, LatticePoint c) {
  const std::int64_t bx = b.column - a.column, by = b.row - a.row;
  const std::int64_t cx = c.column - a.column, cy = c.row - a.row;
  return bx * cy - by * cx;
}

/// Walks along a straight line in whole numbers: from + i * rise / count for i = 0, 1, … as a whole
/// number and a rest, exactly.
class WholeSteps {
public:
  /// REQUIRES count > 0.
  WholeSteps(int from, int rise, int count)
      : whole_(from), step_(rise / count), rest_step_(rise % count), count_(count) {
    if (rest_step_ < 0) {
      --step_;
      rest_step_ += count;
    }
  }

  void next() {
    whole_ += step_;
    rest_ += rest_step_;
    if (rest_ >= count_) {
      rest_ -= count_;
      ++whole_;
    }
  }

  int floor() const { return whole_; }
  int ceiling() const { return whole_ + (rest_ > 0 ? 1 : 0); }
  bool is_whole() const { return rest_ == 0; }
  /// What is beyond the floor, from 0 to below 1.
  double share() const { return static_cast<double>(rest_) / static_cast<double>(count_); }

private:
  int whole_, step_;
  std::int64_t rest_ = 0, rest_step_, count_;
};

/// A corner and its height.
struct LatticeCorner {
  LatticePoint at;
  double height_m = 0;
};

/// A triangle between grid vertices: those that it covers, and its height at them. The same numbers
/// whatever the order in which the corners are given.
class LatticePlane {
public:
  /// REQUIRES corners that aren't on one line.
  explicit LatticePlane(std::array<LatticeCorner, 3> corners) : corners_(corners) {
    std::sort(corners_.begin(), corners_.end(), [](const auto& one, const auto& other) {
      return one.at.row != other.at.row ? one.at.row < other.at.row
                                        : one.at.column < other.at.column;
    });
    const auto& [a, b, c] = corners_;
    area_ = twice_area(a.at, b.at, c.at);
    to_b_ = (b.height_m - a.height_m) / static_cast<double>(area_);
    to_c_ = (c.height_m - a.height_m) / static_cast<double>(area_);
  }

  /// Right to a few roundings of the corners' heights, however thin the triangle.
  double height_m(LatticePoint at) const {
    const auto& [a, b, c] = corners_;
    return a.height_m + (static_cast<double>(twice_area(a.at, at, c.at)) * to_b_ +
                         static_cast<double>(twice_area(a.at, b.at, at)) * to_c_);
  }

  bool is_corner(LatticePoint at) const {
    return at == corners_[0].at || at == corners_[1].at || at == corners_[2].at;
  }

  /// Calls visit(at, height) for every grid vertex in the triangle, edges and corners included,
  /// row by row; `height` is height_m(at).
  template <class Visit>
  void for_each_vertex(Visit visit) const {
    const auto& [a, b, c] = corners_;
    const bool b_is_west = area_ < 0;
    WholeSteps across(a.at.column, c.at.column - a.at.column, c.at.row - a.at.row);
    const auto from_to = [](LatticePoint from, LatticePoint to) {
      return WholeSteps(from.column, to.column - from.column, std::max(to.row - from.row, 1));
    };
    WholeSteps around = from_to(a.at, b.at);
    for (int row = a.at.row; row <= c.at.row; ++row) {
      if (row == b.at.row) around = from_to(b.at, c.at);
      const int first = (b_is_west ? around : across).ceiling();
      const int last = (b_is_west ? across : around).floor();
      across.next();
      around.next();
      // Weights are whole numbers, so that stepping is exact.
      auto weight_b = static_cast<double>(twice_area(a.at, {first, row}, c.at));
      auto weight_c = static_cast<double>(twice_area(a.at, b.at, {first, row}));
      const double step_b = c.at.row - a.at.row, step_c = a.at.row - b.at.row;
      for (int column = first; column <= last; ++column) {
        visit(LatticePoint{column, row}, a.height_m + (weight_b * to_b_ + weight_c * to_c_));
        weight_b += step_b;
        weight_c += step_c;
      }
    }
  }

private:
  std::array<LatticeCorner, 3> corners_; // from north to south
  std::int64_t area_ = 0;
  double to_b_ = 0, to_c_ = 0; // what a unit of weight adds
};

/// Where an edge crosses one of the grid between its ends.
struct GridCrossing {
  LatticePoint first, last; ///< of the grid's edge
  double share = 0;         ///< how far along the grid's edge, above 0 and below 1
  double height_m = 0;      ///< of the edge that crosses it
};

/// Between the two edges, in height. REQUIRES the grid's own heights, and ground at the crossing.
template <class Value>
double distance_m(const Grid& grid, const Heights<Value>& heights, const GridCrossing& crossing) {
  const auto height_m = [&](LatticePoint p) {
    return static_cast<double>(heights[grid.index(p.column, p.row)]);
  };
  const double first_m = height_m(crossing.first);
  const double grid_m = first_m + crossing.share * (height_m(crossing.last) - first_m);
  return std::abs(grid_m - crossing.height_m);
}

/// An edge between grid vertices, and where it crosses the grid's own edges. The same numbers
/// whichever end is given first.
class LatticeEdge {
public:
  LatticeEdge(const LatticeCorner& one, const LatticeCorner& other) : from_(one), to_(other) {
    if (std::pair(to_.at.row, to_.at.column) < std::pair(from_.at.row, from_.at.column))
      std::swap(from_, to_);
  }

  /// Calls visit(crossing) for every column line, row line and diagonal that it crosses, except
  /// where it does so at a vertex.
  template <class Visit>
  void for_each_crossing(Visit visit) const {
    for (const Lines lines : {Lines::columns, Lines::rows, Lines::diagonals}) {
      const OnLine begin = on_line(lines, from_.at), end = on_line(lines, to_.at);
      const int count = std::abs(end.line - begin.line), step = end.line < begin.line ? -1 : 1;
      if (count < 2) continue;
      const double rise_m = to_.height_m - from_.height_m;
      WholeSteps place(begin.place, end.place - begin.place, count);
      for (int i = 1; i < count; ++i) {
        place.next();
        if (place.is_whole()) continue;
        const int line = begin.line + i * step;
        visit(GridCrossing{vertex_at(lines, {line, place.floor()}),
                           vertex_at(lines, {line, place.floor() + 1}), place.share(),
                           from_.height_m + static_cast<double>(i) / count * rise_m});
      }
    }
  }

private:
  // The grid's three families of parallel edges. Each line of one has a number, and each vertex on
  // it a place, one from the next.
  enum class Lines { columns, rows, diagonals };
  struct OnLine {
    int line, place;
  };

  static OnLine on_line(Lines lines, LatticePoint p) {
    if (lines == Lines::columns) return {p.column, p.row};
    if (lines == Lines::rows) return {p.row, p.column};
    return {p.column - p.row, p.row};
  }
  static LatticePoint vertex_at(Lines lines, OnLine at) {
    if (lines == Lines::columns) return {at.line, at.place};
    if (lines == Lines::rows) return {at.place, at.line};
    return {at.line + at.place, at.place};
  }

  LatticeCorner from_, to_;
};

} // namespace orograph
