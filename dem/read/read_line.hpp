// SPDX-License-Identifier: GPL-3.0-or-later
// A single line in a vector file: a way, not a part of the terrain.
#pragma once

#include "geometry/vec.hpp"

#include <string>
#include <vector>

namespace orograph {

struct MapLine {
  std::vector<Vec3> points; ///< in the units of its CRS, easting or longitude first
  bool has_heights = false;
  std::string crs_wkt; ///< empty where the file has none
};

/// Throws Error where GDAL doesn't open the file as vectors, where it doesn't hold exactly one line
/// (LineString, or MultiLineString of one), and where a coordinate isn't finite.
/// `allow_network` as in ReadOptions.
MapLine read_line(const std::string& path, bool allow_network = false);

} // namespace orograph
