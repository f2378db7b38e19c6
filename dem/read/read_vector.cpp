// SPDX-License-Identifier: GPL-3.0-or-later
// Triangles, points, lines and rings from vector layers, through OGR.
#include "dem/read/crs_frame.hpp"
#include "dem/read/length_units.hpp"
#include "dem/read/map_shapes.hpp"
#include "dem/read/vector_layer.hpp"
#include "geometry/error.hpp"
#include "geometry/on_all_cores.hpp"

#include <cpl_string.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gdal_priv.h>
#include <ogr_geometry.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "gdal/gdal.hpp"

namespace orograph {
namespace {

// How messages name a feature.
std::string feature_name(std::int64_t id, const std::string& path) {
  return fmt::format("feature {} of {}", id, path);
}

// Where a geometry goes, and what is known of its feature.
struct Target {
  VectorUse use;
  std::optional<double> height;
  std::int64_t id;
  MapShapes& shapes;

  std::string feature() const { return feature_name(id, shapes.path); }
};

[[noreturn]] void refuse_flat(const char* what, const Target& target) {
  throw Error(fmt::format("{} is a {} without heights (2D)", target.feature(), what),
              fmt::format("give it a Z coordinate, from a field for example: ogr2ogr -zfield FIELD "
                          "with_z.gpkg {}",
                          target.shapes.path));
}

[[noreturn]] void refuse_use(const OGRGeometry& geometry, const Target& target) {
  const char* hint = "give layers of points, lines with Z, or triangles";
  if (target.use == VectorUse::breaklines)
    hint = "breaklines are lines with Z; 'ogr2ogr -nlt MULTILINESTRING' makes lines of polygons";
  if (target.use == VectorUse::boundary)
    hint = "a boundary is polygons; 'ogr2ogr -nlt POLYGON' makes polygons of closed lines";
  throw Error(fmt::format("{} is a {}", target.feature(),
                          OGRToOGCGeomType(wkbFlatten(geometry.getGeometryType()))),
              hint);
}

void check_finite(Vec3 p, bool height_matters, const Target& target) {
  if (!std::isfinite(p.x) || !std::isfinite(p.y))
    throw Error(fmt::format("{} has a corner at {}, {}", target.feature(), p.x, p.y),
                "coordinates must be finite numbers");
  if (height_matters && !std::isfinite(p.z))
    throw Error(
        fmt::format("{} has the height {} at {:.10g}, {:.10g}", target.feature(), p.z, p.x, p.y),
        "every height must be a finite number; take the point out or give it one");
}

void add_point(const OGRPoint& point, const Target& target) {
  if (point.IsEmpty()) return;
  if (!target.height && !point.Is3D())
    throw Error(fmt::format("{} is a point without a height (2D)", target.feature()),
                "name the field that holds it with `height_field`, or give points a Z coordinate");
  const Vec3 p{point.getX(), point.getY(), target.height ? *target.height : point.getZ()};
  check_finite(p, true, target);
  target.shapes.points.push_back(p);
}

std::vector<Vec3> points_of(const OGRSimpleCurve& curve) {
  std::vector<Vec3> points;
  points.reserve(static_cast<std::size_t>(curve.getNumPoints()));
  for (int i = 0; i < curve.getNumPoints(); ++i)
    points.push_back({curve.getX(i), curve.getY(i), curve.getZ(i)});
  return points;
}

void add_line(const OGRLineString& line, const Target& target) {
  if (line.IsEmpty()) return;
  if (!line.Is3D()) refuse_flat("line", target);
  std::vector<Vec3> points = points_of(line);
  for (const Vec3& p : points) check_finite(p, true, target);
  if (points.size() < 2)
    throw Error(fmt::format("{} is a line of a single point", target.feature()),
                "a breakline has two points at least");
  target.shapes.breaklines.push_back(std::move(points));
}

// Without the last point that closes it. Corners that repeat their neighbour go only where there
// are more than three: a triangle of no area is dropped and counted later.
std::vector<Vec3> corners_of(const OGRLinearRing& ring) {
  std::vector<Vec3> points = points_of(ring);
  if (points.size() > 1 && points.front() == points.back()) points.pop_back();
  if (points.size() > 3) points.erase(std::unique(points.begin(), points.end()), points.end());
  while (points.size() > 3 && points.front() == points.back()) points.pop_back();
  return points;
}

void add_triangle(const OGRPolygon& polygon, const Target& target) {
  if (polygon.IsEmpty()) return;
  if (!polygon.Is3D()) refuse_flat("polygon", target);
  if (polygon.getNumInteriorRings() > 0)
    throw Error(fmt::format("{} is a polygon with a hole, not a triangle", target.feature()),
                "split it into triangles (in QGIS: Tessellate)");
  const std::vector<Vec3> corners = corners_of(*polygon.getExteriorRing());
  for (const Vec3& p : corners) check_finite(p, true, target);
  if (corners.size() != 3)
    throw Error(fmt::format("{} has a face with {} corners", target.feature(), corners.size()),
                "split it into triangles (in QGIS: Tessellate); polygons that bound a survey go to "
                "`boundary`");
  const auto first = static_cast<std::uint32_t>(target.shapes.points.size());
  target.shapes.points.insert(target.shapes.points.end(), corners.begin(), corners.end());
  target.shapes.triangles.push_back({first, first + 1, first + 2});
}

void add_ring(const OGRLinearRing& ring, const Target& target) {
  std::vector<Vec3> points = points_of(ring);
  for (const Vec3& p : points) check_finite(p, false, target);
  if (points.size() > 1 && points.front().x == points.back().x &&
      points.front().y == points.back().y)
    points.pop_back();
  if (points.size() < 3)
    throw Error(fmt::format("{} has a ring of {} points", target.feature(), points.size()),
                "a boundary's ring has three at least");
  const bool has_heights = ring.Is3D() && std::all_of(points.begin(), points.end(),
                                                      [](Vec3 p) { return std::isfinite(p.z); });
  if (!has_heights)
    for (Vec3& p : points) p.z = std::numeric_limits<double>::quiet_NaN();
  target.shapes.rings.push_back(std::move(points));
}

void add_polygon(const OGRPolygon& polygon, const Target& target) {
  if (target.use == VectorUse::breaklines) refuse_use(polygon, target);
  if (target.use == VectorUse::terrain) return add_triangle(polygon, target);
  if (polygon.IsEmpty()) return;
  for (const OGRLinearRing* ring : polygon) add_ring(*ring, target);
}

void add(const OGRGeometry& geometry, const Target& target) {
  switch (wkbFlatten(geometry.getGeometryType())) {
  case wkbPoint:
    if (target.use != VectorUse::terrain) refuse_use(geometry, target);
    return add_point(*geometry.toPoint(), target);
  case wkbLineString:
    if (target.use == VectorUse::boundary) refuse_use(geometry, target);
    return add_line(*geometry.toLineString(), target);
  case wkbPolygon:
  case wkbTriangle:
    return add_polygon(*geometry.toPolygon(), target);
  case wkbPolyhedralSurface:
  case wkbTIN:
    for (const OGRPolygon* patch : *geometry.toPolyhedralSurface()) add_polygon(*patch, target);
    return;
  case wkbMultiPoint:
  case wkbMultiLineString:
  case wkbMultiPolygon:
  case wkbGeometryCollection:
    for (const OGRGeometry* part : *geometry.toGeometryCollection()) add(*part, target);
    return;
  case wkbCircularString:
  case wkbCompoundCurve:
  case wkbCurvePolygon:
  case wkbMultiCurve:
  case wkbMultiSurface:
    throw Error(
        fmt::format("{} has curves ({})", target.feature(), geometry.getGeometryName()),
        fmt::format("make straight lines of them: ogr2ogr -nlt CONVERT_TO_LINEAR straight.gpkg {}",
                    target.shapes.path));
  default:
    refuse_use(geometry, target);
  }
}

// Adds what the geometry of feature `id` is. `height` is that of points, where a field tells it.
// Throws Error where the geometry can't serve.
void add_geometry(const OGRGeometry& geometry, VectorUse use, std::optional<double> height,
                  std::int64_t id, MapShapes& shapes) {
  add(geometry, {use, height, id, shapes});
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
    const std::vector<std::string> names = field_names(layer);
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
  const Dataset vector = open_vector(path, options.open_options);
  return vector && vector->GetLayerCount() > 0 && !is_raster_file(path, options);
}

bool is_raster_file(const std::string& path, const ReadOptions& options) {
  GdalMessages messages;
  CPLStringList open_options;
  for (const std::string& option : options.open_options) open_options.AddString(option.c_str());
  const Dataset raster(GDALDataset::Open(path.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY, nullptr,
                                         open_options.List(), nullptr));
  return raster && raster->GetRasterCount() > 0;
}

MapShapes read_vector(const std::string& path, VectorUse use, const ReadOptions& options) {
  GdalMessages messages;
  const Dataset dataset = open_vector(path, options.open_options);
  if (!dataset)
    throw Error(
        fmt::format("{} can't be opened as a vector file ({})", path, messages.last_failure()),
        "give layers that GDAL reads, such as GeoPackage, Shapefile or GeoJSON");
  const bool is_terrain = use == VectorUse::terrain;
  OGRLayer& layer =
      layer_of(*dataset, path, is_terrain ? options.layer : "",
               "name one with `layer`, or copy it to a file of its own: ogr2ogr one.gpkg " + path +
                   " LAYER");
  MapShapes shapes;
  shapes.path = path;
  if (layer.GetFeatureCount() == 0) refuse_empty(path, layer.GetName());
  const bool height_unit_assumed = !set_frame(*dataset, layer, shapes);
  const int field = height_field(layer, path, is_terrain ? options.height_field : "");
  add_doubts(messages, path, shapes.doubts);
  messages.forget(); // drivers that were asked before may have failed

  bool height_unit_told = !height_unit_assumed;
  std::uint64_t without = 0;
  layer.ResetReading();
  for (const auto& feature : layer) {
    throw_if_stopped();
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
  add_doubts(messages, path, shapes.doubts);
  shapes.notes.insert(shapes.notes.begin(), shapes.doubts.begin(), shapes.doubts.end());
  if (!height_unit_told)
    shapes.notes.push_back(fmt::format("{} names no unit of height: that of its CRS is taken, {}.",
                                       path, shapes.map.unit_name));
  if (without > 0)
    shapes.notes.push_back(
        fmt::format("{} of the features of {} have no geometry.", without, path));
  return shapes;
}

} // namespace orograph
