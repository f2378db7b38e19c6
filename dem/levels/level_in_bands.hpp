// SPDX-License-Identifier: GPL-3.0-or-later
// A level of a grid that never is in memory as a whole: its rows come in bands.
#pragma once

#include "dem/levels/ground_around.hpp"
#include "dem/levels/larger_cells.hpp"
#include "dem/levels/level_windows.hpp"

#include <cstddef>
#include <deque>
#include <map>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace orograph {

/// Some rows of a grid, row-major; several levels may share them.
template <class Height>
struct Band {
  int first_row = 0, rows = 0;
  std::shared_ptr<const std::vector<Height>> heights;
};

/// The heights that `generalised` makes, to the bit, but for what is level: there a vertex whose
/// eight neighbours are as high keeps its height, since whether it is a lake's is known only once
/// all of the grid is. Memory: the level, and of the grid the last rows, some `3 * step`.
template <class Height>
class LevelInBands {
public:
  /// REQUIRES what `generalised` does.
  LevelInBands(int columns, int rows, int step);

  /// REQUIRES that bands follow each other. Cost: some 6 ns a height, on all cores.
  void take(const Band<Height>& band);

  // Once all rows are there.

  int columns() const { return static_cast<int>(across_.size()); }
  int rows() const { return static_cast<int>(down_.size()); }
  const std::vector<Height>& heights() const { return heights_; }
  std::vector<Height> move_heights() { return std::move(heights_); }
  /// With the `most` highest summits.
  LargerCells larger_cells(std::size_t most) const;

private:
  std::span<const Height> line(int row) const;
  void gather(const Band<Height>& band);
  void make_rows();
  void compare(int end_row);
  void forget();

  int step_, file_columns_, file_rows_;
  std::vector<LevelWindow> across_, down_;
  std::vector<PlaceInLevel> place_across_, place_down_;
  std::deque<Band<Height>> bands_;
  std::map<std::size_t, RowGathering<Height>>
      begun_;                             ///< rows of the level that go on in the next band
  std::vector<AroundRow> around_;         ///< empty before and after they are needed
  std::size_t around_end_ = 0, made_ = 0; ///< rows of the level
  std::vector<Height> heights_;
  std::vector<RowDeparture> departures_;
  int compared_ = 0; ///< rows of the grid
  int side_;         ///< of squares of which one summit is taken at most
  TopsInRows tops_;
};

} // namespace orograph
