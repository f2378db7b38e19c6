// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/read/read_vector.hpp"

#include "dem/read/crs_frame.hpp"
#include "dem/read/gdal_dataset.hpp"
#include "dem/read/gdal_messages.hpp"
#include "dem/read/length_units.hpp"
#include "dem/read/vector_shapes.hpp"
#include "geometry/error.hpp"

#include <cpl_string.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

namespace orograph {
namespace {

Dataset open(const std::string& path, unsigned kind, const ReadOptions& options) {
  CPLStringList open_options;
  for (const std::string& option : options.open_options) open_options.AddString(option.c_str());
  return Dataset(GDALDataset::Open(path.c_str(), kind | GDAL_OF_READONLY | GDAL_OF_VERBOSE_ERROR,
                                   nullptr, open_options.List(), nullptr));
}

OGRLayer& layer_of(GDALDataset& dataset, const std::string& path, const std::string& wanted) {
  std::vector<OGRLayer*> layers;
  for (OGRLayer* layer : dataset.GetLayers())
    if (layer->GetGeomType() != wkbNone) layers.push_back(layer);
  std::vector<std::string> names;
  for (OGRLayer* layer : layers) names.emplace_back(layer->GetName());
  for (std::size_t i = 0; i < layers.size(); ++i)
    if (names[i] == wanted) return *layers[i];
  if (layers.empty())
    throw Error(fmt::format("{} has no layer with geometries", path),
                "see 'ogrinfo' for what it holds");
  if (!wanted.empty())
    throw Error(fmt::format("{} has no layer '{}'", path, wanted),
                fmt::format("its layers are {}", fmt::join(names, ", ")));
  if (layers.size() > 1)
    throw Error(fmt::format("{} has {} layers: {}", path, layers.size(), fmt::join(names, ", ")),
                "name one with --input-layer, or copy it to a file of its own: ogr2ogr one.gpkg " +
                    path + " LAYER");
  return *layers.front();
}

// GeoJSON's own rule is degrees when it names no CRS, and GDAL follows it; surveys in it often have
// metres or feet all the same.
bool is_local_geojson(GDALDataset& dataset, const OGRSpatialReference* crs, const Box2& extent) {
  const std::string_view driver = dataset.GetDriverName();
  if (!crs || !crs->IsGeographic() || !driver.starts_with("GeoJSON")) return false;
  return extent.low.x < -360 || extent.high.x > 360 || extent.low.y < -90 || extent.high.y > 90;
}

[[noreturn]] void refuse_empty(const std::string& path, const std::string& layer) {
  throw Error(fmt::format("the layer '{}' of {} is empty", layer, path), "it must hold geometries");
}

// False where there is a CRS and the unit of heights isn't known: then it is taken to be the same.
bool set_frame(GDALDataset& dataset, OGRLayer& layer, MapShapes& shapes) {
  OGREnvelope envelope;
  Box2 extent;
  if (layer.GetExtent(&envelope, TRUE) == OGRERR_NONE)
    extent = {{envelope.MinX, envelope.MinY}, {envelope.MaxX, envelope.MaxY}};
  const OGRSpatialReference* crs = layer.GetSpatialRef();
  if (!tells_place(crs) || is_local_geojson(dataset, crs, extent)) return true;
  set_crs(shapes.map, *crs, shapes.path, FileKind::vector, extent.centre());
  shapes.units_known = true;
  if (set_height_unit(shapes.map, *crs)) return true;
  shapes.map.height_unit_m = shapes.map.unit_m;
  shapes.map.height_unit_name = shapes.map.unit_name;
  return false;
}

int height_field(OGRLayer& layer, const std::string& path, const std::string& name) {
  if (name.empty()) return -1;
  OGRFeatureDefn& fields = *layer.GetLayerDefn();
  const int index = fields.GetFieldIndex(name.c_str());
  if (index < 0) {
    std::vector<std::string> names;
    for (int i = 0; i < fields.GetFieldCount(); ++i)
      names.emplace_back(fields.GetFieldDefn(i)->GetNameRef());
    throw Error(fmt::format("{} has no field '{}'", path, name),
                names.empty() ? "it has no fields"
                              : fmt::format("its fields are {}", fmt::join(names, ", ")));
  }
  const OGRFieldType type = fields.GetFieldDefn(index)->GetType();
  if (type != OFTReal && type != OFTInteger && type != OFTInteger64)
    throw Error(fmt::format("{}: the field '{}' holds no numbers ({})", path, name,
                            OGRFieldDefn::GetFieldTypeName(type)),
                fmt::format("make numbers of it: ogr2ogr -sql 'SELECT *, CAST({} AS FLOAT) AS "
                            "height FROM {}' numbers.gpkg {}",
                            name, layer.GetName(), path));
  return index;
}

std::optional<double> height_of(const OGRFeature& feature, int field, const std::string& path) {
  if (field < 0) return std::nullopt;
  if (!feature.IsFieldSetAndNotNull(field))
    throw Error(fmt::format("{} has no height in the field '{}'",
                            feature_name(feature.GetFID(), path),
                            feature.GetFieldDefnRef(field)->GetNameRef()),
                "give every point a height, or take the point out");
  return feature.GetFieldAsDouble(field);
}

// What `write_tin` says of heights, since a CRS often doesn't; whether it is there.
bool read_height_unit(const OGRFeature& feature, MapShapes& shapes) {
  const int field = feature.GetFieldIndex("height_unit_m");
  if (field < 0 || !feature.IsFieldSetAndNotNull(field)) return false;
  const double unit_m = feature.GetFieldAsDouble(field);
  if (!std::isfinite(unit_m) || unit_m <= 0)
    throw Error(fmt::format("{} has height_unit_m = {}",
                            feature_name(feature.GetFID(), shapes.path), unit_m),
                "it must be a length in metres");
  shapes.map.height_unit_m = unit_m;
  shapes.map.height_unit_name = unit_name(unit_m);
  return true;
}

void read_error(const OGRFeature& feature, MapShapes& shapes) {
  const int field = feature.GetFieldIndex("surface_error_m");
  if (field < 0 || !feature.IsFieldSetAndNotNull(field)) return;
  const double error = feature.GetFieldAsDouble(field);
  if (!std::isfinite(error) || error < 0)
    throw Error(fmt::format("{} has surface_error_m = {}",
                            feature_name(feature.GetFID(), shapes.path), error),
                "it must be a length in metres");
  shapes.surface_error_m = std::max(shapes.surface_error_m, error);
}

void check_content(const MapShapes& shapes, const std::string& layer) {
  const bool triangles = !shapes.triangles.empty();
  const bool mixed = shapes.points.size() > 3 * shapes.triangles.size();
  if (triangles && (mixed || !shapes.breaklines.empty()))
    throw Error(fmt::format("the layer '{}' of {} holds triangles beside points or lines", layer,
                            shapes.path),
                "keep one kind: ogr2ogr -where \"OGR_GEOMETRY='POLYGON'\" one.gpkg " + shapes.path);
  if (shapes.points.empty() && shapes.breaklines.empty() && shapes.rings.empty())
    refuse_empty(shapes.path, layer);
}

} // namespace

bool is_vector_file(const std::string& path, const ReadOptions& options) {
  GdalMessages messages;
  const Dataset vector = open(path, GDAL_OF_VECTOR, options);
  return vector && vector->GetLayerCount() > 0 && !is_raster_file(path, options);
}

bool is_raster_file(const std::string& path, const ReadOptions& options) {
  GdalMessages messages;
  const Dataset raster = open(path, GDAL_OF_RASTER, options);
  return raster && raster->GetRasterCount() > 0;
}

MapShapes read_vector(const std::string& path, VectorUse use, const ReadOptions& options) {
  GdalMessages messages;
  const Dataset dataset = open(path, GDAL_OF_VECTOR, options);
  if (!dataset)
    throw Error(
        fmt::format("{} can't be opened as a vector file ({})", path, messages.last_failure()),
        "give layers that GDAL reads, such as GeoPackage, Shapefile or GeoJSON");
  const bool is_terrain = use == VectorUse::terrain;
  OGRLayer& layer = layer_of(*dataset, path, is_terrain ? options.layer : "");
  MapShapes shapes;
  shapes.path = path;
  for (const std::string& warning : messages.warnings())
    shapes.notes.push_back(fmt::format("GDAL warns: {}.", warning));
  if (layer.GetFeatureCount() == 0) refuse_empty(path, layer.GetName());
  const bool height_unit_assumed = !set_frame(*dataset, layer, shapes);
  const int field = height_field(layer, path, is_terrain ? options.height_field : "");
  messages.forget();

  bool height_unit_told = !height_unit_assumed;
  std::uint64_t without = 0;
  layer.ResetReading();
  for (const auto& feature : layer) {
    const OGRGeometry* geometry = feature->GetGeometryRef();
    if (!geometry || geometry->IsEmpty()) {
      ++without;
      continue;
    }
    const OGRwkbGeometryType type = wkbFlatten(geometry->getGeometryType());
    const bool is_point = type == wkbPoint || type == wkbMultiPoint;
    add_geometry(*geometry, use, is_point ? height_of(*feature, field, path) : std::nullopt,
                 feature->GetFID(), shapes);
    read_error(*feature, shapes);
    height_unit_told = read_height_unit(*feature, shapes) || height_unit_told;
  }
  if (const std::string failure = messages.last_failure(); failure != "no reason given")
    throw Error(fmt::format("{} can't be read to its end ({})", path, failure),
                "check it with 'ogrinfo -al'");
  check_content(shapes, layer.GetName());
  if (!height_unit_told)
    shapes.notes.push_back(fmt::format("{} names no unit of height: that of its CRS is taken, {}.",
                                       path, shapes.map.unit_name));
  if (without > 0)
    shapes.notes.push_back(
        fmt::format("{} of the features of {} have no geometry.", without, path));
  return shapes;
}

} // namespace orograph
