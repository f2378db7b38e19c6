// SPDX-License-Identifier: GPL-3.0-or-later
// What a comment in a mesh file tells: CRS, units, error.
#pragma once

#include "dem/read/map_shapes.hpp"

#include <string_view>

namespace orograph {

/// From lines of comment ('#' in OFF and OBJ, 'comment' in PLY):
///     orograph: crs WKT
///     orograph: units METRES_IN_A_UNIT METRES_IN_A_UNIT_OF_HEIGHT
///     orograph: surface_error_m METRES
/// each on one line. `text` may be the whole file. Throws Error where one of them can't be right.
void read_mesh_comments(std::string_view text, MapShapes& shapes);

} // namespace orograph
