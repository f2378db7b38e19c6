// SPDX-License-Identifier: GPL-3.0-or-later
// A grid's own triangles: which are there, and all of them as a Tin.
#pragma once

#include "dem/grid.hpp"
#include "dem/tin.hpp"

#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

namespace orograph {

/// One row of cells by column; 1 where the triangle is there. A cell more at the end is empty and
/// stands for what is beyond the grid.
struct CellRow {
  std::vector<unsigned char> lower, upper;

  explicit CellRow(int columns)
      : lower(static_cast<std::size_t>(columns)), upper(static_cast<std::size_t>(columns)) {}
};

/// The cells between `row` and the next one; empty below the grid's last row. `heights` are the
/// grid's own.
template <class Value>
void find_triangles(const Grid& grid, const Heights<Value>& heights, int row, CellRow& cells) {
  if (row + 1 >= grid.rows) {
    cells = CellRow(grid.columns);
    return;
  }
  const auto width = static_cast<std::size_t>(grid.columns);
  const Value* north = heights.data() + grid.index(0, row);
  const Value* south = north + width;
  for (std::size_t c = 0; c + 1 < width; ++c) {
    const bool diagonal = !std::isnan(north[c]) && !std::isnan(south[c + 1]);
    cells.lower[c] = diagonal && !std::isnan(south[c]);
    cells.upper[c] = diagonal && !std::isnan(north[c + 1]);
  }
}

/// How many triangles around vertex `column` of a row are there, between the cells north and south
/// of the row: up to 6.
inline int triangles_around(std::size_t column, const CellRow& north, const CellRow& south) {
  int count = north.lower[column] + south.lower[column] + south.upper[column];
  if (column > 0)
    count += north.lower[column - 1] + north.upper[column - 1] + south.upper[column - 1];
  return count;
}

/// The Tin of the grid's own triangles: the same surface. Vertices keep their order; those without
/// a triangle are left out. Triangles go cell after cell, the lower one of a cell before its upper
/// one. A grid without a triangle gives an empty Tin. Cost and memory O(vertices), at the speed of
/// memory. REQUIRES fewer than 2^31 vertices and steps that span a plane, whichever way round.
Tin tin_of(const Grid& grid);

/// The same of some of its triangles. `leave_out` is called with each row of cells, by the number
/// of the row of vertices north of it, more than once, and takes triangles away. Memory grows with
/// the triangles that are left.
Tin tin_of(const Grid& grid, const std::function<void(int row, CellRow& cells)>& leave_out);

} // namespace orograph
