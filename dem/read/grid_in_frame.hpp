// SPDX-License-Identifier: GPL-3.0-or-later
// A grid's vertices in the ground frame, whatever its heights come from.
#pragma once

#include "dem/grid.hpp"
#include "dem/read/raster_order.hpp"
#include "dem/terrain.hpp"

#include <string>
#include <vector>

namespace orograph {

/// A grid without heights. On a map plane the origin is at vertex (0, 0): then positions are whole
/// multiples of the steps, the same numbers however the file stores them. In degrees it is in the
/// frame of `map.earth`; then throws Error where it is turned against meridians, reaches a pole or
/// goes round the earth more than once. `paths` are what messages call it.
Grid empty_grid(const GridOrder& order, const MapFrame& map, const std::vector<std::string>& paths);

/// Whether any vertex has one.
bool has_height(const Grid& grid);

} // namespace orograph
