// SPDX-License-Identifier: GPL-3.0-or-later
// Small rasters for the tests of the reader, written through GDAL.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace orograph {

struct RasterFile {
  int pixels = 0, lines = 0;
  std::vector<double> values; ///< raw, line by line; the same in every band
  std::string type = "Float32";
  std::optional<std::array<double, 6>> geotransform;
  std::string crs = "EPSG:32632"; ///< anything that OGR takes, empty for none
  std::optional<double> nodata;
  std::optional<double> scale, offset;
  std::string unit = "m";
  int bands = 1;
  std::vector<std::string> creation_options;
  std::vector<std::string> colours; ///< meaning of each band by GDAL's name
  std::vector<int> overviews;       ///< factors
  std::string area_or_point;
  bool control_points = false;
};

/// Writes a GeoTIFF. Throws std::runtime_error if GDAL doesn't do as asked.
void write_raster(const RasterFile& raster, const std::string& path);

/// A raster with the values 0, 1, 2, … in cells of 10 m, upper left corner at (500000, 5000000).
RasterFile counting_raster(int pixels, int lines);

} // namespace orograph
