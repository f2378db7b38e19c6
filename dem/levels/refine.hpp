// SPDX-License-Identifier: GPL-3.0-or-later
// A grid's own terrain in smaller cells, smooth through its heights.
#pragma once

#include "dem/grid.hpp"

namespace orograph {

/// Each cell of a grid in `parts` times `parts`, on the same lattice and with the same diagonals.
/// The grid's heights stay, and so do its triangles: where one is missing, all of its parts are.
/// Between heights the surface is a cubic along rows and columns whose slopes are limited (Fritsch
/// and Carlson 1980), so that no height leaves the range of its cell's corners: beside cliffs,
/// shores and voids it doesn't swing. A level triangle stays level; a plane stays one. Slopes go on
/// from cell to cell. REQUIRES parts >= 2. Cost: some 60 ns a height of the new grid.
Grid refined(const Grid& grid, int parts);

} // namespace orograph
