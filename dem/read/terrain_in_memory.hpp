// SPDX-License-Identifier: GPL-3.0-or-later
// Terrains of what a program has in memory.
#pragma once

#include "dem/read/terrain_input.hpp"
#include "dem/terrain.hpp"

namespace orograph {

/// The same terrain, to the bit, as `read_terrain` makes of a file that holds the same. Throws
/// Error where it isn't a surface: sizes that don't fit, fewer than 2 x 2 vertices, a geotransform
/// whose axes fall together, no height at all; a CRS that isn't understood; and as `read_raster`
/// does for grids in degrees, `tin_from_triangles` for triangles.
TerrainData terrain_of(const GridInput& input);
TerrainData terrain_of(const TinInput& input);

} // namespace orograph
