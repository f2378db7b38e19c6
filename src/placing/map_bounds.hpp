// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dem/terrain.hpp"
#include "geometry/box.hpp"

namespace orograph {

/// Box of all vertices in the terrain's own coordinates.
Box2 map_bounds(const TerrainData& terrain);

} // namespace orograph
