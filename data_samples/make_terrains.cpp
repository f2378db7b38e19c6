// SPDX-License-Identifier: GPL-3.0-or-later
// make_terrains OUT_DIR [VERTICES]: writes every made terrain as a GeoTIFF, heights rounded to
// decimetres. They lie in the Gulf of Guinea, where nobody takes them for real ones.
#include <cpl_string.h>
#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <memory>
#include <string>

#include "data_samples/terrains.hpp"

namespace {

using orograph::Grid;
using orograph::Vec2;

constexpr Vec2 corner{500000, 100000}; // south-west vertex, UTM zone 31N
constexpr int committed_vertices = 301;

bool write(const Grid& grid, const std::string& path) {
  CPLStringList options;
  for (const char* option : {"COMPRESS=DEFLATE", "PREDICTOR=3", "ZLEVEL=9", "BLOCKYSIZE=301"})
    options.AddString(option);
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
  const std::unique_ptr<GDALDataset> dataset(
      driver->Create(path.c_str(), grid.columns, grid.rows, 1, GDT_Float32, options.List()));
  if (!dataset) return false;

  OGRSpatialReference crs;
  crs.importFromEPSG(32631);
  const double step = grid.column_step_m.x;
  const Vec2 first = corner + grid.first_vertex_m;
  std::array<double, 6> geotransform{first.x - step / 2, step, 0, first.y + step / 2, 0, -step};
  auto heights = std::get<std::vector<float>>(grid.heights_m);
  for (float& height : heights)
    height = static_cast<float>(std::floor(10. * static_cast<double>(height) + 0.5) / 10);
  GDALRasterBand& band = *dataset->GetRasterBand(1);
  const bool written =
      dataset->SetSpatialRef(&crs) == CE_None &&
      dataset->SetGeoTransform(geotransform.data()) == CE_None &&
      band.SetUnitType("m") == CE_None &&
      band.RasterIO(GF_Write, 0, 0, grid.columns, grid.rows, heights.data(), grid.columns,
                    grid.rows, GDT_Float32, 0, 0, nullptr) == CE_None;
  dataset->FlushCache(true);
  return written && CPLGetLastErrorType() < CE_Failure;
}

} // namespace

int main(int count, char** arguments) {
  int vertices = committed_vertices;
  if (count == 3) std::from_chars(arguments[2], arguments[2] + std::strlen(arguments[2]), vertices);
  if (count < 2 || count > 3 || vertices < 2) {
    std::fprintf(stderr, "usage: make_terrains OUT_DIR [VERTICES]\n");
    return 2;
  }
  GDALAllRegister();
  for (const auto terrain : orograph::all_made_terrains) {
    const std::string path = std::string(arguments[1]) + "/" + name_of(terrain) + ".tif";
    if (!write(make_terrain(terrain, vertices), path)) {
      std::fprintf(stderr, "make_terrains: error: %s can't be written\n", path.c_str());
      return 1;
    }
  }
  return 0;
}
