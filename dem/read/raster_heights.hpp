// SPDX-License-Identifier: GPL-3.0-or-later
// From a band's raw values to heights in metres, in a Grid's order.
#pragma once

#include "dem/grid.hpp"
#include "dem/read/raster_order.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

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

/// A Grid's heights while they are read.
using ReadHeights = std::variant<std::vector<float>, std::vector<double>>;

/// Whether float holds all values of the band: it does unless the band is Float64 or integers of 32
/// bits and more.
bool fits_float(GDALRasterBand& band);

/// Where heights are read at places that have one already.
struct HeightDifferences {
  std::size_t count = 0; ///< of heights that differ from the one that was there
  double greatest_m = 0;
};

/// Whether the window has blocks that the file doesn't hold because they were never written. GDAL
/// asks the file system of each block.
bool has_unwritten_blocks(GDALRasterBand& band, const RasterWindow& window);

/// Reads the window, each of the file's blocks once, to the places in `heights` that the order
/// names. A mask that the file holds makes NaN as nodata does. With `differences` only places that
/// are NaN take a height, else all do. Returns what GDAL warned of, each once. Throws Error if a
/// read fails, as it does in a truncated file.
std::vector<std::string> read_heights(GDALRasterBand& band, const RasterWindow& window,
                                      const GridOrder& order, const HeightCode& code,
                                      const std::string& path, ReadHeights& heights,
                                      HeightDifferences* differences);

/// What became of vertices without a height.
struct FilledVoids {
  std::size_t filled = 0, left = 0; ///< how many
};

/// Fills missing heights from those around them, by inverse distance in eight directions, as GDAL
/// does (GDALFillNodata, without smoothing), no farther than `cells` from a height. Heights that
/// are there stay what they are. Throws Error where GDAL fails.
FilledVoids fill_voids(Grid& grid, double cells);

} // namespace orograph
