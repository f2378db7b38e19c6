// SPDX-License-Identifier: GPL-3.0-or-later
// Writes one of the benchmarks' terrains as an uncompressed GeoTIFF of float32: mountains with
// slopes as steep at every size, or fractal_alps of the samples, smooth at the size of a cell.
//
//   make_fractal fractal|smooth VERTICES OUTPUT.tif
#include "bench/scenes.hpp"
#include "data_samples/terrains.hpp"

#include <gdal_priv.h>

#include <array>
#include <charconv>
#include <cstdio>
#include <cstring>
#include <memory>
#include <string_view>
#include <variant>

namespace {

using namespace orograph;

// In metres, UTM zone 32N; the raster's cells are centred on the vertices.
bool write_geotiff(Grid grid, const char* path) {
  GDALAllRegister();
  GDALDriver* const driver = GetGDALDriverManager()->GetDriverByName("GTiff");
  const std::unique_ptr<GDALDataset> dataset(
      driver ? driver->Create(path, grid.columns, grid.rows, 1, GDT_Float32, nullptr) : nullptr);
  if (!dataset) return false;
  const PlaneLattice& plane = grid.plane();
  const double cell_m = plane.column_step_m.x;
  std::array<double, 6> transform{500000 + plane.first_vertex_m.x - cell_m / 2,  cell_m, 0,
                                  5000000 + plane.first_vertex_m.y + cell_m / 2, 0,      -cell_m};
  OGRSpatialReference crs;
  crs.importFromEPSG(32632);
  const auto heights = std::get<Heights<float>>(grid.heights_m).own();
  return dataset->SetGeoTransform(transform.data()) == CE_None &&
         dataset->SetSpatialRef(&crs) == CE_None &&
         dataset->GetRasterBand(1)->RasterIO(GF_Write, 0, 0, grid.columns, grid.rows,
                                             heights.data(), grid.columns, grid.rows, GDT_Float32,
                                             0, 0) == CE_None &&
         (dataset->FlushCache(), CPLGetLastErrorType() < CE_Failure);
}

} // namespace

int main(int count, char** arguments) {
  int vertices = 0;
  const std::string_view kind = count == 4 ? arguments[1] : "";
  if (count == 4) std::from_chars(arguments[2], arguments[2] + std::strlen(arguments[2]), vertices);
  if ((kind != "fractal" && kind != "smooth") || vertices < 2 || vertices > 40000) {
    std::fputs("usage: make_fractal fractal|smooth VERTICES OUTPUT.tif\n"
               "(2 to 40000 vertices a side)\n",
               stderr);
    return 2;
  }
  if (write_geotiff(kind == "smooth" ? make_terrain(MadeTerrain::fractal_alps, vertices)
                                     : fractal_terrain(vertices),
                    arguments[3]))
    return 0;
  std::fprintf(stderr, "make_fractal: error: %s can't be written: name a folder with free space\n",
               arguments[3]);
  return 1;
}
