// SPDX-License-Identifier: GPL-3.0-or-later
// The height of the terrain at a ground point.
#pragma once

#include "dem/grid.hpp"

#include <optional>

namespace orograph {

/// Height in metres on the triangle that holds the point (ground frame, metres); none outside of
/// the grid and where the triangle isn't there. Exact at vertices.
std::optional<double> height_at(const Grid& grid, Vec2 ground_m);

} // namespace orograph
