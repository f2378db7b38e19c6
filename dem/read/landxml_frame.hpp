// SPDX-License-Identifier: GPL-3.0-or-later
// Units and CRS of a LandXML file.
#pragma once

#include "dem/read/map_shapes.hpp"

#include <string>

namespace orograph {

/// As written in a LandXML file; empty where it isn't.
struct LandxmlPlace {
  std::string linear_unit;    ///< Units/*/@linearUnit
  std::string elevation_unit; ///< Units/*/@elevationUnit
  std::string epsg_code, wkt; ///< CoordinateSystem/@epsgCode, @ogcWktCode
};

/// Sets `shapes.map`, after the points are read. Throws Error for a unit that isn't known and a CRS
/// in degrees.
void set_landxml_frame(const LandxmlPlace& place, MapShapes& shapes);

} // namespace orograph
