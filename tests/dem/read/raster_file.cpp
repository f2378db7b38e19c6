// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/dem/read/raster_file.hpp"

#include "tests/dem/read/demand.hpp"

#include <cpl_string.h>
#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <memory>
#include <numeric>

namespace orograph {
namespace {

void set_place(GDALDataset& dataset, const RasterFile& raster) {
  if (raster.geotransform) {
    auto gt = *raster.geotransform;
    demand(dataset.SetGeoTransform(gt.data()) == CE_None, "no geotransform in the test raster");
  }
  if (!raster.crs.empty()) {
    OGRSpatialReference crs;
    demand(crs.SetFromUserInput(raster.crs.c_str()) == OGRERR_NONE, "no CRS in the test raster");
    demand(dataset.SetSpatialRef(&crs) == CE_None, "no CRS in the test raster");
  }
  if (raster.control_points) {
    std::array<GDAL_GCP, 3> points;
    GDALInitGCPs(3, points.data());
    points[1].dfGCPPixel = points[1].dfGCPX = raster.pixels;
    points[2].dfGCPLine = points[2].dfGCPY = raster.lines;
    demand(dataset.SetGCPs(3, points.data(), dataset.GetSpatialRef()) == CE_None,
           "no GCPs in the test raster");
    GDALDeinitGCPs(3, points.data());
  }
}

void set_meaning(GDALRasterBand& band, const RasterFile& raster) {
  if (raster.nodata)
    demand(band.SetNoDataValue(*raster.nodata) == CE_None, "no nodata in the test raster");
  if (raster.scale) demand(band.SetScale(*raster.scale) == CE_None, "no scale in the test raster");
  if (raster.offset)
    demand(band.SetOffset(*raster.offset) == CE_None, "no offset in the test raster");
  if (!raster.unit.empty())
    demand(band.SetUnitType(raster.unit.c_str()) == CE_None, "no unit in the test raster");
  if (raster.colours.empty()) return;
  const std::string& colour = raster.colours.at(static_cast<std::size_t>(band.GetBand() - 1));
  if (colour == "Palette") {
    GDALColorTable table;
    const GDALColorEntry grey{128, 128, 128, 255};
    table.SetColorEntry(0, &grey);
    demand(band.SetColorTable(&table) == CE_None, "no palette in the test raster");
    return;
  }
  band.SetColorInterpretation(GDALGetColorInterpretationByName(colour.c_str()));
}

} // namespace

void write_raster(const RasterFile& raster, const std::string& path) {
  GDALAllRegister();
  CPLStringList options;
  for (const std::string& option : raster.creation_options) options.AddString(option.c_str());
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
  demand(driver, "no GTiff in the test raster");
  const GDALDataType type = GDALGetDataTypeByName(raster.type.c_str());
  const std::unique_ptr<GDALDataset> dataset(driver->Create(
      path.c_str(), raster.pixels, raster.lines, raster.bands, type, options.List()));
  demand(dataset != nullptr, "no create in the test raster");
  set_place(*dataset, raster);
  if (!raster.area_or_point.empty())
    dataset->SetMetadataItem("AREA_OR_POINT", raster.area_or_point.c_str());
  for (int number = 1; number <= raster.bands; ++number) {
    GDALRasterBand& band = *dataset->GetRasterBand(number);
    set_meaning(band, raster);
    auto values = raster.values;
    if (values.empty()) continue; // left unwritten
    demand(band.RasterIO(GF_Write, 0, 0, raster.pixels, raster.lines, values.data(), raster.pixels,
                         raster.lines, GDT_Float64, 0, 0, nullptr) == CE_None,
           "nothing written to the test raster");
  }
  if (!raster.overviews.empty()) {
    auto factors = raster.overviews;
    demand(dataset->BuildOverviews("NEAREST", static_cast<int>(factors.size()), factors.data(), 0,
                                   nullptr, nullptr, nullptr) == CE_None,
           "no overviews in the test raster");
  }
}

RasterFile counting_raster(int pixels, int lines) {
  RasterFile raster;
  raster.pixels = pixels;
  raster.lines = lines;
  raster.values.resize(static_cast<std::size_t>(pixels) * static_cast<std::size_t>(lines));
  std::iota(raster.values.begin(), raster.values.end(), 0.);
  raster.geotransform = {500000, 10, 0, 5000000, 0, -10};
  return raster;
}

} // namespace orograph
