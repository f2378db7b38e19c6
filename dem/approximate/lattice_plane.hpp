// SPDX-License-Identifier: GPL-3.0-or-later
// A triangle between grid vertices: the vertices that it covers, and its height at them.
#pragma once

#include "dem/approximate/lattice_triangulation.hpp"
#include "dem/approximate/whole_steps.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

namespace orograph {

/// A corner and its height.
struct LatticeCorner {
  LatticePoint at;
  double height_m = 0;
};

/// The same numbers whatever the order in which the corners are given.
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

} // namespace orograph
