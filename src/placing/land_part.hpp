// SPDX-License-Identifier: GPL-3.0-or-later
// Where on a grid there is land.
#pragma once

#include "dem/grid.hpp"
#include "dem/levels/part_of_grid.hpp"
#include "placing/map_spec.hpp"
#include "profiles/triangles.hpp"

#include <optional>

namespace orograph {

/// The part of a grid that holds all land and a strip of open water about it, where a drawing shows
/// nothing of the rest: neither lines on water, nor its border, nor what is draped or measured out
/// over all of the terrain. None where the rest is less than a tenth, and in views from an eye,
/// which may look at land over the sea's horizon. `water` is the grid's. Cost: a look at each
/// triangle of open water.
std::optional<GridPart> land_part(const Grid& grid, const TriangleSet& water, const MapSpec& spec);

} // namespace orograph
