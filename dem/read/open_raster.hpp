// SPDX-License-Identifier: GPL-3.0-or-later
// Opening a raster, and saying what is wrong with one that can't be terrain.
#pragma once

#include "dem/read/gdal_dataset.hpp"
#include "dem/read/gdal_messages.hpp"

#include <string>
#include <vector>

class GDALRasterBand;

namespace orograph {

/// Throws Error with a hint: not there, not a raster, an archive, a container of several rasters.
Dataset open_raster(const std::string& path, const std::vector<std::string>& open_options,
                    GdalMessages& messages);

/// Band `number`, counted from 1. Throws Error where there is none or it doesn't hold heights:
/// colours, a palette, complex numbers.
GDALRasterBand& height_band(GDALDataset& dataset, const std::string& path, int number);

/// The overview `level` of the same file, after checking that there is one.
Dataset open_overview(const std::string& path, std::vector<std::string> open_options,
                      GDALRasterBand& full, int level, GdalMessages& messages);

} // namespace orograph
