// SPDX-License-Identifier: GPL-3.0-or-later
// Values at a terrain's vertices, for lines of equal value.
#pragma once

#include "dem/terrain.hpp"
#include "profiles/isolines.hpp"

#include <utility>

namespace orograph {

/// Heights as the file has them, in metres, whatever the view makes of them. REQUIRES that the
/// terrain outlives what comes back, here and below.
VertexValues heights_of(const TerrainData& terrain);

/// The least and the greatest of these; the first is greater than the second where there is none.
std::pair<double, double> height_range_of(const TerrainData& terrain);

/// Map coordinates, in the units of the terrain's CRS: x, or y.
enum class MapAxis { x, y };
VertexValues map_coordinates_of(const TerrainData& terrain, MapAxis axis);

/// The least and the greatest; the first is greater than the second where there is none.
std::pair<double, double> range_of(const Surface& surface, const VertexValues& values);

} // namespace orograph
