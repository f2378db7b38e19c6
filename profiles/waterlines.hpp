// SPDX-License-Identifier: GPL-3.0-or-later
// Lines on level ground that follow its shores at given distances.
#pragma once

#include "dem/surface.hpp"
#include "profiles/isolines.hpp"
#include "profiles/level_ground.hpp"

#include <span>

namespace orograph {

/// Where the distance to the nearest shore is one of `distances_m`. It is exact at vertices of
/// level ground, along straight lines, and linear between them. REQUIRES rising distances above 0.
/// Cost: O(log shores) for each vertex of level ground; memory 8 bytes a vertex of the surface.
Isolines waterlines(const Surface& surface, const LevelGround& level,
                    std::span<const double> distances_m);

} // namespace orograph
