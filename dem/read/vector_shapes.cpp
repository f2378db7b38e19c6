// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/read/vector_shapes.hpp"

#include "geometry/error.hpp"

#include <fmt/format.h>
#include <ogr_geometry.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace orograph {
namespace {

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
                "name the field that holds it with --height-field, or give points a Z coordinate");
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
                "--boundary");
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

} // namespace

std::string feature_name(std::int64_t id, const std::string& path) {
  return fmt::format("feature {} of {}", id, path);
}

void add_geometry(const OGRGeometry& geometry, VectorUse use, std::optional<double> height,
                  std::int64_t id, MapShapes& shapes) {
  add(geometry, {use, height, id, shapes});
}

} // namespace orograph
