// SPDX-License-Identifier: GPL-3.0-or-later
// A GeoPackage through OGR: one layer, one TIN Z.
#include "dem/read/gdal_dataset.hpp"
#include "dem/read/gdal_messages.hpp"
#include "dem/write/tin_writers.hpp"
#include "geometry/error.hpp"

#include <cpl_conv.h>
#include <cpl_string.h>
#include <fmt/format.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>
#include <unistd.h>

#include <cstdint>
#include <memory>

namespace orograph {
namespace {

constexpr const char* kLayerName = "tin";

// SQLite holds up to 1e9 bytes in one value, and GDAL up to 2^31; a triangle is a polygon with a
// ring of four points there.
constexpr std::uint64_t kTriangleBytes = 1 + 4 + 4 + 4 + 4 * 3 * 8;
constexpr std::uint64_t kMostTriangles = 9'000'000;
static_assert(kMostTriangles * kTriangleBytes + 1000 < 1'000'000'000);

// The same bytes on any day.
class FixedDate {
public:
  FixedDate() { set("2000-01-01T00:00:00.000Z"); }
  ~FixedDate() { set(nullptr); }
  FixedDate(const FixedDate&) = delete;
  FixedDate& operator=(const FixedDate&) = delete;

private:
  static void set(const char* date) { CPLSetThreadLocalConfigOption("OGR_CURRENT_DATE", date); }
};

std::unique_ptr<OGRTriangulatedSurface> geometry_of(const Terrain& terrain, const Tin& tin) {
  const auto point = [&](std::uint32_t vertex) {
    const Vec3 at = terrain.map.to_map(tin.vertices_m[vertex]);
    return OGRPoint(at.x, at.y, at.z);
  };
  auto surface = std::make_unique<OGRTriangulatedSurface>();
  surface->set3D(TRUE);
  for (const auto& [a, b, c] : tin.triangles)
    surface->addGeometryDirectly(new OGRTriangle(point(a), point(b), point(c)));
  return surface;
}

// GDAL takes none for a geographic one; this name it knows for what it is (srs_id -1).
constexpr const char* kNoCrs = "Undefined Cartesian SRS";

bool set_crs(const MapFrame& map, OGRSpatialReference& crs) {
  crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  if (map.crs_wkt.empty()) return crs.SetLocalCS(kNoCrs) == OGRERR_NONE;
  return crs.importFromWkt(map.crs_wkt.c_str()) == OGRERR_NONE;
}

OGRLayer* add_layer(GDALDataset& dataset, const MapFrame& map) {
  OGRSpatialReference crs;
  if (!set_crs(map, crs)) return nullptr;
  CPLStringList options;
  options.SetNameValue("SPATIAL_INDEX", "NO"); // of one feature
  OGRLayer* const layer = dataset.CreateLayer(kLayerName, &crs, wkbTINZ, options.List());
  if (layer == nullptr) return nullptr;
  for (const char* name : {"surface_error_m", "height_unit_m"}) {
    OGRFieldDefn field(name, OFTReal);
    if (layer->CreateField(&field) != OGRERR_NONE) return nullptr;
  }
  return layer;
}

// Whether all went well, up to and including the closing.
bool write(const Terrain& terrain, const std::string& path, const GdalMessages& messages) {
  GDALDriver* const driver = GetGDALDriverManager()->GetDriverByName("GPKG");
  if (driver == nullptr) throw Error("GDAL has no GPKG here", "a GDAL that has it");
  ::unlink(path.c_str()); // the driver creates it and nothing else
  Dataset dataset(driver->Create(path.c_str(), 0, 0, 0, GDT_Unknown, nullptr));
  OGRLayer* const layer = dataset ? add_layer(*dataset, terrain.map) : nullptr;
  if (layer == nullptr) return false;
  {
    OGRFeature feature(layer->GetLayerDefn());
    feature.SetField("height_unit_m", terrain.map.height_unit_m);
    if (terrain.surface_error_m > 0) feature.SetField("surface_error_m", terrain.surface_error_m);
    feature.SetGeometryDirectly(geometry_of(terrain, std::get<Tin>(terrain.surface)).release());
    if (layer->CreateFeature(&feature) != OGRERR_NONE) return false;
  }
  dataset.reset();
  return !messages.has_failure();
}

std::string first_value(GDALDataset& dataset, const char* sql) {
  OGRLayer* const rows = dataset.ExecuteSQL(sql, nullptr, nullptr);
  if (rows == nullptr) return {};
  std::string value;
  if (const OGRFeatureUniquePtr row(rows->GetNextFeature()); row) value = row->GetFieldAsString(0);
  dataset.ReleaseResultSet(rows);
  return value;
}

// Closing doesn't tell of everything that was lost on a full disk: opened again, the database has
// to be whole and its one geometry to have room for every triangle.
bool is_whole(const std::string& path, std::uint64_t triangles, const GdalMessages& messages) {
  const char* const drivers[] = {"GPKG", nullptr};
  const Dataset dataset(GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR, drivers));
  const auto enough = fmt::format("SELECT COUNT(*) FROM {} WHERE LENGTH(geom) >= {}", kLayerName,
                                  triangles * kTriangleBytes);
  return dataset && first_value(*dataset, "PRAGMA quick_check(1)") == "ok" &&
         first_value(*dataset, enough.c_str()) == "1" && !messages.has_failure();
}

} // namespace

void write_tin_geopackage(const Terrain& terrain, const std::string& path,
                          const std::string& name) {
  const std::uint64_t triangles = std::get<Tin>(terrain.surface).triangles.size();
  if (triangles > kMostTriangles)
    throw Error(fmt::format("{} triangles are more than one geometry of a GeoPackage holds ({})",
                            triangles, kMostTriangles),
                "write OFF, PLY or OBJ");
  const FixedDate fixed;
  GdalMessages messages;
  if (!write(terrain, path, messages) || !is_whole(path, triangles, messages))
    throw Error(fmt::format("{} can't be written ({})", name, messages.last_failure()),
                "a disk with room for it, and a folder that you may write to");
}

} // namespace orograph
