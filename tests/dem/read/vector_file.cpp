// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/dem/read/vector_file.hpp"

#include "tests/dem/read/demand.hpp"

#include <cpl_conv.h>
#include <cpl_string.h>
#include <gdal_priv.h>
#include <ogr_spatialref.h>
#include <ogrsf_frmts.h>

#include <limits>
#include <memory>

namespace orograph {
namespace {

class MarkedToNan : public OGRDefaultGeometryVisitor {
public:
  void visit(OGRPoint* point) override {
    if (point->getZ() == -12345) point->setZ(std::numeric_limits<double>::quiet_NaN());
  }
};

OGRGeometryUniquePtr geometry_of(const std::string& wkt) {
  OGRGeometry* geometry = nullptr;
  demand(OGRGeometryFactory::createFromWkt(wkt.c_str(), nullptr, &geometry) == OGRERR_NONE,
         "no geometry in the test file");
  MarkedToNan visitor;
  geometry->accept(&visitor);
  return OGRGeometryUniquePtr(geometry);
}

// Not all formats can hold a layer of anything.
OGRwkbGeometryType type_of(const VectorFile& file) {
  if (file.driver == "GPKG" || file.features.empty()) return wkbUnknown;
  return geometry_of(file.features[0].wkt)->getGeometryType();
}

void add_feature(const VectorFeature& given, OGRLayer& layer) {
  OGRFeature feature(layer.GetLayerDefn());
  if (given.height) feature.SetField("height", *given.height);
  if (given.surface_error_m) feature.SetField("surface_error_m", *given.surface_error_m);
  if (!given.wkt.empty()) feature.SetGeometryDirectly(geometry_of(given.wkt).release());
  demand(layer.CreateFeature(&feature) == OGRERR_NONE, "no feature in the test file");
}

} // namespace

void write_vector(const VectorFile& file, const std::string& path) {
  GDALAllRegister();
  CPLSetConfigOption("OGR_SQLITE_SYNCHRONOUS", "OFF"); // the files don't outlive the test
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName(file.driver.c_str());
  demand(driver, "no such driver for the test file");
  const std::unique_ptr<GDALDataset> dataset(
      file.append ? GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR | GDAL_OF_UPDATE)
                  : driver->Create(path.c_str(), 0, 0, 0, GDT_Unknown, nullptr));
  demand(dataset != nullptr, "no create in the test file");
  OGRSpatialReference crs;
  crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  if (!file.crs.empty())
    demand(crs.SetFromUserInput(file.crs.c_str()) == OGRERR_NONE, "no CRS in the test file");
  CPLStringList options;
  if (file.driver == "GeoJSON") options.SetNameValue("RFC7946", "NO");
  OGRLayer* layer = dataset->CreateLayer(file.layer.c_str(), file.crs.empty() ? nullptr : &crs,
                                         type_of(file), options.List());
  demand(layer, "no layer in the test file");
  if (file.driver != "DXF") {
    OGRFieldDefn height("height", file.height_type == "Real" ? OFTReal : OFTString);
    OGRFieldDefn error("surface_error_m", OFTReal);
    demand(layer->CreateField(&height) == OGRERR_NONE && layer->CreateField(&error) == OGRERR_NONE,
           "no field in the test file");
  }
  for (const VectorFeature& feature : file.features) add_feature(feature, *layer);
}

} // namespace orograph
