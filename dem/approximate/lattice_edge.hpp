// SPDX-License-Identifier: GPL-3.0-or-later
// An edge between grid vertices, and where it crosses the grid's own edges.
#pragma once

#include "dem/approximate/lattice_plane.hpp"
#include "dem/approximate/lattice_triangulation.hpp"
#include "dem/approximate/whole_steps.hpp"
#include "dem/grid.hpp"

#include <array>
#include <cmath>
#include <cstdlib>
#include <utility>
#include <vector>

namespace orograph {

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

/// The same numbers whichever end is given first.
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
