// SPDX-License-Identifier: GPL-3.0-or-later
// How far a level of a grid is from the grid.
#pragma once

#include "dem/grid.hpp"

namespace orograph {

/// Of heights, at the vertices of the file's grid where both have one.
struct Departure {
  double greatest_m = 0, rms_m = 0;
};

/// REQUIRES a level that has the grid's corners. Cost: some 3 ns a height of `grid`.
Departure departure_of(const Grid& level, const Grid& grid);

} // namespace orograph
