// SPDX-License-Identifier: GPL-3.0-or-later
// The highest summits of a grid.
#pragma once

#include "dem/grid.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace orograph {

/// A vertex that none beside it is higher than.
struct Top {
  double height_m;
  int column, row;

  bool operator==(const Top&) const = default;
};

/// The `most` highest, from the highest on: each the highest ground within `side` rows and columns,
/// one at most of a square of so many. Cost: one look at each height.
std::vector<Top> tops_of(const Grid& grid, int side, std::size_t most);

/// The same of a grid whose rows come one by one.
class TopsInRows {
public:
  TopsInRows(int columns, int rows, int side);

  /// Rows of different squares may be added at a time. `above` and `below` are the rows beside;
  /// empty at a border.
  template <class Height>
  void add(int row, std::span<const Height> above, std::span<const Height> line,
           std::span<const Height> below);
  std::vector<Top> tops(std::size_t most) const;

private:
  struct Highest {
    Top at;
    bool is_top;
  };

  int side_;
  std::size_t across_;
  std::vector<Highest> squares_; ///< row-major
};

} // namespace orograph
