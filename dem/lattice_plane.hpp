// SPDX-License-Identifier: GPL-3.0-or-later
// A triangle between grid vertices: the vertices that it covers, and its height at them.
#pragma once

#include "dem/lattice_triangulation.hpp"

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
    for (int row = a.at.row; row <= c.at.row; ++row) {
      const Fraction across = at_row(a.at, c.at, row);
      const Fraction around = row == b.at.row  ? Fraction{b.at.column, true}
                              : row < b.at.row ? at_row(a.at, b.at, row)
                                               : at_row(b.at, c.at, row);
      const Fraction& west = b_is_west ? around : across;
      const Fraction& east = b_is_west ? across : around;
      const int first = west.floor + (west.whole ? 0 : 1), last = east.floor;
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
  struct Fraction {
    int floor;
    bool whole;
  };

  // Where the edge meets a row. REQUIRES from.row < to.row.
  static Fraction at_row(LatticePoint from, LatticePoint to, int row) {
    const std::int64_t height = to.row - from.row;
    const std::int64_t run = std::int64_t{row - from.row} * (to.column - from.column);
    const std::int64_t quotient = run / height, rest = run % height;
    return {from.column + static_cast<int>(quotient) - (rest < 0 ? 1 : 0), rest == 0};
  }

  std::array<LatticeCorner, 3> corners_; // from north to south
  std::int64_t area_ = 0;
  double to_b_ = 0, to_c_ = 0; // what a unit of weight adds
};

} // namespace orograph
