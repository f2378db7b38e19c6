// SPDX-License-Identifier: GPL-3.0-or-later
// Tiles cut from one raster.
#pragma once

#include "tests/dem/read/raster_file.hpp"

#include <utility>

namespace orograph {

/// The cells from (pixel, line) on, as a raster of their own. REQUIRES an upright north-up one.
inline RasterFile cut_from(const RasterFile& whole, int pixel, int line, int pixels, int lines) {
  RasterFile tile = whole;
  tile.pixels = pixels;
  tile.lines = lines;
  tile.values.clear();
  for (int l = line; l < line + lines; ++l)
    for (int p = pixel; p < pixel + pixels; ++p)
      tile.values.push_back(whole.values[static_cast<std::size_t>(l * whole.pixels + p)]);
  auto& gt = *tile.geotransform;
  gt[0] += pixel * gt[1];
  gt[3] += line * gt[5];
  return tile;
}

/// The same ground stored with its first line in the south.
inline RasterFile south_up(const RasterFile& raster) {
  RasterFile turned = raster;
  for (int l = 0; l < raster.lines; ++l)
    for (int p = 0; p < raster.pixels; ++p)
      turned.values[static_cast<std::size_t>((raster.lines - 1 - l) * raster.pixels + p)] =
          raster.values[static_cast<std::size_t>(l * raster.pixels + p)];
  auto& gt = *turned.geotransform;
  gt[3] += raster.lines * gt[5];
  gt[5] = -gt[5];
  return turned;
}

/// The same ground with lines that run south.
inline RasterFile transposed(const RasterFile& raster) {
  RasterFile turned = raster;
  std::swap(turned.pixels, turned.lines);
  for (int l = 0; l < raster.lines; ++l)
    for (int p = 0; p < raster.pixels; ++p)
      turned.values[static_cast<std::size_t>(p * raster.lines + l)] =
          raster.values[static_cast<std::size_t>(l * raster.pixels + p)];
  auto& gt = *turned.geotransform;
  gt = {gt[0], gt[2], gt[1], gt[3], gt[5], gt[4]};
  return turned;
}

} // namespace orograph
