// SPDX-License-Identifier: GPL-3.0-or-later
// Reading a DEM through GDAL; the only place that knows GDAL's raster side.
#pragma once

#include "dem/read/read_options.hpp"
#include "dem/terrain.hpp"

#include <string>

namespace orograph {

/// Reads one band of any raster that GDAL opens as heights in metres, vertices at cell centres,
/// brought to the order of `Grid` whatever the file's own (south-up, mirrored, rotated).
/// Nodata (compared with raw values, before scale and offset) and infinities become NaN.
/// Without georeference cells have size 1 m and row 0 is in the north, and a note says so.
/// Heights are float unless the band is Float64 or an integer type that float can't hold
/// (32 bits and more). Memory: the heights, and a strip of rows while reading.
///
/// Throws Error: the file is missing, not a raster, truncated or unreadable; the band, overview or
/// window doesn't exist or holds fewer than 2 x 2 vertices; every height is nodata; the CRS is
/// geographic (degrees) or geocentric; the image is colours (Terrain-RGB, RGBA bytes, a palette),
/// complex, or has ground control points only.
Terrain read_raster(const std::string& path, const ReadOptions& options = {});

} // namespace orograph
