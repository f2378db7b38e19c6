// SPDX-License-Identifier: GPL-3.0-or-later
// Reading a DEM, of one file or of many, through GDAL; the only place that knows GDAL's raster
// side.
#pragma once

#include "dem/read/read_options.hpp"
#include "dem/terrain.hpp"

#include <functional>
#include <string>
#include <vector>

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
TerrainData read_raster(const std::string& path, const ReadOptions& options = {});

/// The same of several files as one terrain (dem/read/join_tiles.hpp): bit for bit what one file of
/// all of them gives. Where files overlap the first that has a height there is taken, and a note
/// tells of heights that differ; where there is no file there is no height. Every file's place,
/// units and CRS are read before any heights; then one file at a time is open, and only the parts
/// inside the window are read. Heights are double if one of the files' are. Memory: the joined
/// heights, and a strip of one file's rows.
///
/// Throws Error also where files differ in CRS, in what heights are above or in their lattice,
/// don't touch, or have no georeference. REQUIRES at least one. `progress` is told the share read
/// of rasters that are read in larger cells.
TerrainData read_rasters(const std::vector<std::string>& paths, const ReadOptions& options = {},
                         const std::function<void(double)>& progress = {});

} // namespace orograph
