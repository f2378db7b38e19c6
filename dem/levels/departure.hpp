// SPDX-License-Identifier: GPL-3.0-or-later
// How far a level of a grid is from the grid.
#pragma once

#include "dem/grid.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace orograph {

/// Of heights, at the vertices of the file's grid where both have one.
struct Departure {
  double greatest_m = 0, rms_m = 0;
};

/// REQUIRES a level that has the grid's corners. Cost: some 3 ns a height of `grid`.
Departure departure_of(const Grid& level, const Grid& grid);

/// Between three corners of a cell that is split from north-west to south-east, at shares of it
/// from the west and from the north; NaN where one that has a share in it is.
inline double height_in_cell(double north_west, double north_east, double south_west,
                             double south_east, double x, double y) {
  const auto part = [](double share, double height) { return share == 0 ? 0 : share * height; };
  return x > y ? part(1 - x, north_west) + part(x - y, north_east) + part(y, south_east)
               : part(1 - y, north_west) + part(y - x, south_west) + part(x, south_east);
}

// The same of a grid whose rows come one by one.

/// Where a row or a column of the grid is in the level: between which two, and how far into that
/// cell.
struct PlaceInLevel {
  int cell;
  double share;
};

/// Of so many rows, or columns, in a level that has `of_level` of them.
std::vector<PlaceInLevel> places_in_level(int vertices, int of_level);

/// What the heights of one row depart by.
struct RowDeparture {
  double greatest_m = 0, squares = 0;
  std::uint64_t count = 0;
};

/// `upper` and `lower` are the level's rows between which the row is, `share` of a cell below the
/// upper; `across` are the places of its columns.
template <class Height>
RowDeparture departure_of_row(std::span<const Height> row, std::span<const Height> upper,
                              std::span<const Height> lower, double share,
                              const std::vector<PlaceInLevel>& across);

/// Of all rows, in their order.
Departure departure_of(const std::vector<RowDeparture>& rows);

} // namespace orograph
