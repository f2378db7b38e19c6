// SPDX-License-Identifier: GPL-3.0-or-later
// The lines that a drawing is asked for: one for each row of a grid.
#pragma once

#include "dem/grid.hpp"
#include "geometry/profile_point.hpp"

#include <algorithm>

namespace orograph {

/// Lines from west to east, numbered from the south, on the rows or, as orograph's lie, the given
/// share of a row to the north of each. REQUIRES a grid along the map's axes. The surface is
/// evaluated here anew, not by orograph's cut.
struct ProfileLines {
  const Grid& grid;
  double north_of_row = 0; ///< 0 to less than 1

  int count() const { return north_of_row > 0 ? grid.rows - 1 : grid.rows; }
  double depth_m(int line) const { return -(line + north_of_row) * grid.plane().row_step_m.y; }

  /// At a column, or between two.
  double height_m(int line, double column) const {
    const int west = std::clamp(static_cast<int>(column), 0, grid.columns - 2);
    const double east = column - west;
    const int south = grid.rows - 1 - line;
    const double sw = grid.height_m(west, south), se = grid.height_m(west + 1, south);
    if (north_of_row == 0) return sw + east * (se - sw);
    const double nw = grid.height_m(west, south - 1), ne = grid.height_m(west + 1, south - 1);
    // Two planes that meet in the diagonal from north-west to south-east.
    const double down = 1 - north_of_row;
    return east > down ? nw + east * (ne - nw) + down * (se - ne)
                       : nw + down * (sw - nw) + east * (se - sw);
  }
  ProfilePoint at(int line, double column) const {
    return {column * grid.plane().column_step_m.x, depth_m(line), height_m(line, column)};
  }
};

} // namespace orograph
