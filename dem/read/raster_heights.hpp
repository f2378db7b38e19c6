// SPDX-License-Identifier: GPL-3.0-or-later
// From a band's raw values to heights in metres, in a Grid's order.
#pragma once

#include "dem/grid.hpp"
#include "dem/read/raster_order.hpp"

#include <optional>
#include <string>

class GDALRasterBand;

namespace orograph {

/// height in metres = (raw * scale + offset) * unit_m, where raw isn't nodata.
struct HeightCode {
  std::optional<double> nodata;
  double scale = 1, offset = 0, unit_m = 1;

  bool changes_values() const { return scale != 1 || offset != 0 || unit_m != 1; }
};

/// Of the band at full resolution: overviews of some formats don't tell it.
HeightCode height_code(GDALRasterBand& band, double unit_m);

/// Reads the window, each of the file's blocks once, into heights in the given order. A mask that
/// the file holds makes NaN as nodata does. Throws Error if a read fails, as it does in a
/// truncated file.
void read_heights(GDALRasterBand& band, const RasterWindow& window, const GridOrder& order,
                  const HeightCode& code, const std::string& path, Grid& grid);

} // namespace orograph
