// SPDX-License-Identifier: GPL-3.0-or-later
// Reading a terrain of any kind.
#pragma once

#include "dem/read/read_options.hpp"
#include "dem/terrain.hpp"

#include <functional>
#include <string>
#include <vector>

namespace orograph {

/// By what the file is:
///  - a raster that GDAL opens: a Grid (`read_raster`);
///  - triangles in OFF, PLY, OBJ or STL, in LandXML, or in a vector layer that GDAL opens (TIN,
///    PolyhedralSurface and Polygon geometries with Z): a Tin;
///  - points in text with named columns, or in a vector layer (with Z or a height field): the
///    Tin of their triangulation, with the breaklines and the boundary that the options name.
/// Throws Error in one clear line.
TerrainData read_terrain(const std::string& path, const ReadOptions& options = {});

/// Of several files, which must be rasters then: they are joined (`read_rasters`).
/// REQUIRES at least one. `progress` as of `read_rasters`.
TerrainData read_terrain(const std::vector<std::string>& paths, const ReadOptions& options = {},
                         const std::function<void(double)>& progress = {});

} // namespace orograph
