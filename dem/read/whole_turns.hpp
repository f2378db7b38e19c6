// SPDX-License-Identifier: GPL-3.0-or-later
// Longitudes that are whole turns apart are the same place.
#pragma once

#include "dem/read/join_tiles.hpp"

#include <vector>

namespace orograph {

/// Moves tiles by whole turns of longitude to where they meet: the widest gap between them is cut,
/// and they follow each other eastward from it. The tile at the cut's east keeps its counting.
/// Where gaps are equally wide (there are none, around the whole earth) it is the one that begins
/// westmost as the files count.
void bring_together(std::vector<Tile>& tiles, double turn);

/// `x` plus the whole turns that bring the interval from `x` to `x + width` over most of that from
/// `low` to `high`; as few as may be.
double turned_onto(double x, double width, double low, double high, double turn);

} // namespace orograph
