// SPDX-License-Identifier: GPL-3.0-or-later
// A grid's own terrain in larger cells, as a cartographer would draw it smaller.
#pragma once

#include "dem/grid.hpp"

#include <cstddef>
#include <functional>
#include <vector>

namespace orograph {

/// A grid whose cells are about `step` of the given one's on a side: its borders and corners stay
/// where they are, so cells are stretched until a whole number of them fits in between. Each height
/// is a mean over the cells around, weighted by nearness, which takes noise away; where the ground
/// is a ridge or a valley floor at this size it goes back towards the highest or the lowest of
/// them, which a mean alone would level, and a summit has its own height. What is nearest to a void
/// is one. Where `is_kept` of the vertex that is nearest, its height is taken as it is: a lake
/// stays level. It is asked from several threads. REQUIRES step >= 2 and 3 rows and columns at
/// least. Cost: some 5 ns a height of the given grid.
Grid generalised(const Grid& grid, int step,
                 const std::function<bool(int column, int row)>& is_kept);

/// Some of a level's vertices, by its columns and rows.
struct LevelPart {
  std::size_t first_column = 0, first_row = 0, columns = 0, rows = 0;
};

/// Where a level's vertices are in a grid, in its columns and rows. The first and last columns and
/// rows are those beside the part that is asked for, but where the level ends.
struct LevelPlaces {
  std::vector<double> columns, rows;
  double step = 1; ///< of the grid's cells to one of the level
};

/// The same heights as those of `generalised`, but at other vertices: of a part of these places;
/// row-major, NaN where there is none. `is_kept` by the grid's columns and rows.
std::vector<double> heights_about(const Grid& grid, const LevelPlaces& places,
                                  const LevelPart& part,
                                  const std::function<bool(int column, int row)>& is_kept);

/// All vertices of the level that has every `step`th column and row of a grid, and its last ones.
LevelPart whole_level(const Grid& grid, int step);

/// Heights of a part of that level, to the bit those of the whole.
std::vector<double> nested_heights(const Grid& grid, int step, const LevelPart& part,
                                   const std::function<bool(int column, int row)>& is_kept);

} // namespace orograph
