// SPDX-License-Identifier: GPL-3.0-or-later
// What the ground is like around the vertices of a level, and what height it gives them.
#pragma once

#include "dem/levels/level_windows.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace orograph {

/// Around the vertices of a row of a level; NaN where what is nearest to one is a void, and beyond
/// both ends of the row, which have a place of their own: vertex 0 is at 1.
struct AroundRow {
  std::vector<double> mean, lowest, highest;
};

/// Gathers a grid's rows, from the first to the last that a row of the level looks at.
template <class Height>
class RowGathering {
public:
  explicit RowGathering(const LevelWindow& window) { begin(window); }
  RowGathering() = default;

  /// Forgets all, for another row of the level.
  void begin(const LevelWindow& window);
  /// A row of the grid, which the window reaches. REQUIRES that they come in order.
  void add(std::span<const Height> line, int row);
  /// Once all are there. `nearest` is the grid's row nearest to the window's middle.
  AroundRow around(std::span<const Height> nearest, const std::vector<LevelWindow>& columns) const;

private:
  LevelWindow window_{};
  double weight_ = 0;           ///< of all columns, while no row has had a void
  std::vector<double> weights_; ///< of each, from then on
  std::vector<double> sum_;
  std::vector<Height> low_, high_;
};

/// The heights of a row's vertices of a level, from what is around each and those beside it: a
/// mean, and where the ground is a ridge or a valley floor something of the highest or the lowest.
/// REQUIRES the rows above and below, where the level has them.
std::vector<double> heights_with_character(std::span<const AroundRow> rows, std::size_t row);

} // namespace orograph
