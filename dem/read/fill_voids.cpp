// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/read/fill_voids.hpp"

#include "dem/read/gdal_dataset.hpp"
#include "geometry/error.hpp"

#include <cpl_string.h>
#include <gdal_alg.h>
#include <gdal_priv.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

namespace orograph {
namespace {

// A raster in memory over the values, which it neither copies nor owns.
template <class Value>
Dataset raster_over(std::vector<Value>& values, int columns, int rows, GDALDataType type) {
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("MEM");
  Dataset dataset(driver ? driver->Create("", columns, rows, 0, type, nullptr) : nullptr);
  char pointer[64];
  pointer[CPLPrintPointer(pointer, values.data(), sizeof pointer - 1)] = '\0';
  CPLStringList band;
  band.SetNameValue("DATAPOINTER", pointer);
  if (!dataset || dataset->AddBand(type, band.List()) != CE_None)
    throw Error("voids can't be filled: GDAL has no rasters in memory here",
                "install GDAL's MEM driver, or leave --fill-voids out");
  return dataset;
}

// GDAL's fill works in single precision, on a copy: heights that are there keep all their digits.
template <class Height>
FilledVoids fill(std::vector<Height>& heights, int columns, int rows, double cells) {
  FilledVoids voids;
  std::vector<std::uint8_t> is_there(heights.size());
  for (std::size_t i = 0; i < heights.size(); ++i) {
    is_there[i] = std::isnan(heights[i]) ? 0 : 255;
    voids.left += is_there[i] == 0;
  }
  if (voids.left == 0 || voids.left == heights.size()) return voids;
  std::vector<float> filled(heights.begin(), heights.end());
  const Dataset surface = raster_over(filled, columns, rows, GDT_Float32);
  const Dataset mask = raster_over(is_there, columns, rows, GDT_Byte);
  CPLStringList options;
  options.SetNameValue("TEMP_FILE_DRIVER", "MEM");
  if (GDALFillNodata(surface->GetRasterBand(1), mask->GetRasterBand(1), cells, 0, 0, options.List(),
                     nullptr, nullptr) != CE_None)
    throw Error("GDAL can't fill the voids", "leave --fill-voids out");
  surface->FlushCache();
  for (std::size_t i = 0; i < heights.size(); ++i)
    if (std::isnan(heights[i]) && !std::isnan(filled[i])) {
      heights[i] = static_cast<Height>(filled[i]);
      ++voids.filled;
      --voids.left;
    }
  return voids;
}

} // namespace

FilledVoids fill_voids(Grid& grid, double cells) {
  return std::visit(
      [&](auto& heights) { return fill(heights.own(), grid.columns, grid.rows, cells); },
      grid.heights_m);
}

} // namespace orograph
