// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dem/grid.hpp"

namespace orograph {

/// Of a grid's true heights, wherever its vertices lie.
struct HeightRange {
  double low_m, high_m, mean_m;
};

/// REQUIRES a vertex with a height. One pass, at the speed of memory.
HeightRange height_range(const Grid& grid);

} // namespace orograph
