// SPDX-License-Identifier: GPL-3.0-or-later
// Nested levels of a grid that never is in memory as a whole: its rows come in bands.
#pragma once

#include "dem/levels/level_in_bands.hpp"
#include "dem/levels/nested_cells.hpp"

#include <cstddef>
#include <deque>
#include <vector>

namespace orograph {

/// Memory: the nested heights, a twelfth of the grid's, and of the grid 64 rows beside the last
/// band.
template <class Height>
class NestedInBands {
public:
  NestedInBands(int columns, int rows);

  /// REQUIRES that bands follow each other. Cost: some 6 ns a height, on all cores.
  void take(const Band<Height>& band);

  /// Once all rows are there.
  NestedCells move_cells();

private:
  struct Sums {
    double greatest_m = 0, squares = 0;
  };

  const Height* line(int row) const;
  void take_rows(int first_row, int last_row);
  void keep_heights(int row, const Height* line);
  void find_ranges(int first_row, const std::vector<const Height*>& lines, int strip);
  void compare(int level, int first_row, const std::vector<const Height*>& lines, int strip);

  NestedCells cells_;
  std::vector<std::vector<Sums>> sums_; ///< by patches, from level 1 on
  std::deque<Band<Height>> bands_;
  int taken_ = 0; ///< rows
};

} // namespace orograph
