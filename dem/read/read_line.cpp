// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/read/read_line.hpp"

#include "dem/read/netcdf_header.hpp"
#include "dem/read/network.hpp"
#include "geometry/error.hpp"

#include <fmt/format.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <cmath>

#include "gdal/gdal.hpp"

namespace orograph {
namespace {

constexpr auto kOneLine =
    "give a file with one line: ogr2ogr -where \"fid = 1\" one.gpkg lines.gpkg";

// The lines of a geometry; those of curves are straight pieces.
void append_lines(const OGRGeometry& geometry, std::vector<const OGRLineString*>& lines) {
  if (wkbFlatten(geometry.getGeometryType()) == wkbLineString)
    lines.push_back(geometry.toLineString());
  else if (OGR_GT_IsSubClassOf(wkbFlatten(geometry.getGeometryType()), wkbGeometryCollection))
    for (const OGRGeometry* part : *geometry.toGeometryCollection()) append_lines(*part, lines);
}

MapLine line_of(const OGRLineString& from, const std::string& path) {
  MapLine line;
  line.has_heights = from.Is3D();
  for (int i = 0; i < from.getNumPoints(); ++i) {
    const Vec3 p{from.getX(i), from.getY(i), line.has_heights ? from.getZ(i) : 0};
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
      throw Error(fmt::format("{} has a corner at {}, {}, {}", path, p.x, p.y, p.z),
                  "coordinates must be finite numbers");
    line.points.push_back(p);
  }
  return line;
}

// GeoJSON is in degrees by its own rule, and often in metres all the same.
bool is_beyond_degrees(const MapLine& line) {
  return std::any_of(line.points.begin(), line.points.end(),
                     [](Vec3 p) { return std::abs(p.x) > 360 || std::abs(p.y) > 90; });
}

std::string wkt_of(const OGRSpatialReference& crs) {
  char* text = nullptr;
  const bool told = crs.exportToWkt(&text) == OGRERR_NONE;
  const std::string wkt = told && text ? text : "";
  CPLFree(text);
  return wkt;
}

} // namespace

MapLine read_line(const std::string& path, bool allow_network) {
  const NetworkGate gate({path}, allow_network);
  check_netcdf_header(path);
  GdalMessages messages;
  const Dataset dataset(GDALDataset::Open(path.c_str(),
                                          GDAL_OF_VECTOR | GDAL_OF_READONLY | GDAL_OF_VERBOSE_ERROR,
                                          nullptr, nullptr, nullptr));
  if (!dataset)
    throw Error(fmt::format("{} can't be read as vectors ({})", path, messages.last_failure()),
                "give a vector file that GDAL opens, such as GeoPackage or GeoJSON");
  std::vector<OGRFeatureUniquePtr> features; // they own the geometries
  std::vector<const OGRLineString*> lines;
  const OGRSpatialReference* crs = nullptr;
  for (OGRLayer* layer : dataset->GetLayers())
    for (OGRFeatureUniquePtr& feature : *layer) {
      const std::size_t before = lines.size();
      if (const OGRGeometry* geometry = feature->GetGeometryRef()) append_lines(*geometry, lines);
      if (lines.size() == before) continue;
      crs = layer->GetSpatialRef();
      features.push_back(std::move(feature));
      if (lines.size() > 1) throw Error(path + " holds more than one line", kOneLine);
    }
  if (lines.empty()) throw Error(path + " holds no line", kOneLine);
  MapLine line = line_of(*lines.front(), path);
  if (crs && !crs->IsLocal() && !(crs->IsGeographic() && is_beyond_degrees(line)))
    line.crs_wkt = wkt_of(*crs);
  return line;
}

} // namespace orograph
