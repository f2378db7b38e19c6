// SPDX-License-Identifier: GPL-3.0-or-later
// A raster that is read in larger cells than its own, and how far these are from its heights.
#pragma once

#include "dem/levels/departure.hpp"
#include "dem/levels/tops.hpp"

#include <vector>

namespace orograph {

struct LargerCells {
  int step = 1;              ///< of the raster's cells to one, about
  int columns = 0, rows = 0; ///< the raster's vertices, between the same borders
  Departure departure;
  std::vector<Top> tops; ///< the raster's highest summits, by its own columns and rows
};

} // namespace orograph
