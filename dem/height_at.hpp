// SPDX-License-Identifier: GPL-3.0-or-later
// The height of the terrain at a ground point.
#pragma once

#include "dem/grid.hpp"

#include <optional>

namespace orograph {

/// Height in metres on a triangle that holds the point (ground frame, metres), its edges included;
/// none outside of the grid and where no such triangle is there. Exact at vertices: a point within
/// 1e-9 of a cell of a column or row line counts as on it.
std::optional<double> height_at(const Grid& grid, Vec2 ground_m);

} // namespace orograph
