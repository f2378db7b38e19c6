// SPDX-License-Identifier: GPL-3.0-or-later
// Reading triangulated surfaces from LandXML.
#pragma once

#include "dem/read/map_shapes.hpp"

#include <string>

namespace orograph {

/// The surface named `surface`, or the only one if that is empty: Surfaces/Surface/Definition with
/// surfType="TIN", its points (northing, easting, elevation) and its visible faces. Units come from
/// the file's Units, the CRS from its CoordinateSystem; one that contradicts the units is left out,
/// with a note. Throws Error: not XML (with the line), not LandXML, no such surface, several, no
/// TIN, a point or face that isn't three numbers, a face of a point that isn't there.
MapShapes read_landxml(const std::string& path, const std::string& surface);

} // namespace orograph
