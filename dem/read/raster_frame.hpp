// SPDX-License-Identifier: GPL-3.0-or-later
// Where a raster lies and in which units.
#pragma once

#include "dem/read/raster_order.hpp"
#include "dem/terrain.hpp"

#include <string>
#include <vector>

class GDALDataset;
class GDALRasterBand;

namespace orograph {

/// Whether there is a geotransform, and not the one that stands for none.
bool has_georeference(GDALDataset& dataset);

/// From the geotransform: vertices at cell centres, in map coordinates. Without one, cells of size
/// 1 with line 0 in the north, and a note. Throws Error where the place is told by control points,
/// RPCs or geolocation arrays only, or the geotransform doesn't span a plane.
RasterLattice raster_lattice(GDALDataset& dataset, const std::string& path,
                             std::vector<std::string>& notes);

/// CRS and units of `band`; the origin stays to be set. `centre` is in map coordinates.
/// `height_unit`, if it isn't empty, goes before the file's own. Throws Error for a geocentric CRS,
/// for an unknown height unit, and where none is told though the CRS's own isn't the metre.
MapFrame raster_map_frame(GDALDataset& dataset, GDALRasterBand& band, const std::string& path,
                          Vec2 centre, const std::string& height_unit,
                          std::vector<std::string>& notes);

} // namespace orograph
