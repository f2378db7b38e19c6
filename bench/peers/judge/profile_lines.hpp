// SPDX-License-Identifier: GPL-3.0-or-later
// The lines that a drawing is asked for: one for each row of a grid.
#pragma once

#include "dem/grid.hpp"
#include "geometry/profile_point.hpp"

#include <algorithm>

namespace orograph {

/// The rows from west to east, numbered from the south. REQUIRES a grid along the map's axes, with
/// more rows than are left out. The surface is evaluated here anew, not by orograph's cut.
struct ProfileLines {
  const Grid& grid;
  int left_out = 0; ///< rows at each end that aren't drawn

  int count() const { return grid.rows - 2 * left_out; }
  double depth_m(int line) const { return -(line + left_out) * grid.plane().row_step_m.y; }

  /// At a column, or between two.
  double height_m(int line, double column) const {
    const int west = std::clamp(static_cast<int>(column), 0, grid.columns - 2);
    const double east = column - west;
    const int row = grid.rows - 1 - left_out - line;
    const double at_west = grid.height_m(west, row), at_east = grid.height_m(west + 1, row);
    return at_west + east * (at_east - at_west);
  }
  ProfilePoint at(int line, double column) const {
    return {column * grid.plane().column_step_m.x, depth_m(line), height_m(line, column)};
  }
};

} // namespace orograph
