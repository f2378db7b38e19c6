// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/write/write_tin.hpp"

#include "geometry/error.hpp"
#include "text/words.hpp"

#include <cpl_string.h>
#include <fmt/format.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <initializer_list>
#include <memory>
#include <string_view>
#include <utility>

#include "gdal/gdal.hpp"
#include "gdal/whole_geopackage.hpp"

namespace orograph {
namespace {

// OFF, ascii PLY and OBJ: a list of vertices, a list of triangles.

// Text on its way to a file, in large pieces.
class TextFile {
public:
  TextFile(const std::string& path, const std::string& name) : name_(name) {
    errno = 0;
    file_.open(path, std::ios::binary | std::ios::trunc);
    check();
  }

  void add(std::string_view text) {
    text_ += text;
    if (text_.size() >= kPiece) write();
  }
  // The shortest decimals that read back to the same number.
  template <class Number>
  void add_number(Number number) {
    char decimals[32];
    const auto end = std::to_chars(std::begin(decimals), std::end(decimals), number).ptr;
    add({decimals, static_cast<std::size_t>(end - decimals)});
  }
  void finish() {
    write();
    file_.close();
    check();
  }

private:
  static constexpr std::size_t kPiece = 1 << 16;

  void write() {
    file_.write(text_.data(), static_cast<std::streamsize>(text_.size()));
    text_.clear();
    check();
  }
  void check() const {
    if (file_) return;
    throw Error(fmt::format("{} can't be written ({})", name_,
                            errno == 0 ? "no reason given" : std::strerror(errno)),
                "a disk with room for it, and a folder that you may write to");
  }

  std::string name_, text_;
  std::ofstream file_;
};

std::string on_one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return text;
}

void add_comments(const TerrainData& terrain, std::string_view mark, TextFile& to) {
  const auto begin = [&](std::string_view what) {
    for (const std::string_view text : {mark, std::string_view(" orograph: "), what}) to.add(text);
  };
  begin("units ");
  to.add_number(terrain.map.unit_m);
  to.add(" ");
  to.add_number(terrain.map.height_unit_m);
  to.add("\n");
  if (!terrain.map.crs_wkt.empty()) {
    begin("crs ");
    to.add(on_one_line(terrain.map.crs_wkt));
    to.add("\n");
  }
  if (terrain.surface_error_m > 0) {
    begin("surface_error_m ");
    to.add_number(terrain.surface_error_m);
    to.add("\n");
  }
}

void add_header(const TerrainData& terrain, const Tin& tin, TinFormat format, TextFile& to) {
  const std::size_t vertices = tin.vertices_m.size(), triangles = tin.triangles.size();
  if (format == TinFormat::off) {
    to.add("OFF\n");
    add_comments(terrain, "#", to);
    to.add(fmt::format("{} {} 0\n", vertices, triangles));
  } else if (format == TinFormat::ply) {
    to.add("ply\nformat ascii 1.0\n");
    add_comments(terrain, "comment", to);
    to.add(fmt::format("element vertex {}\nproperty double x\nproperty double y\n"
                       "property double z\nelement face {}\n"
                       "property list uchar int vertex_indices\nend_header\n",
                       vertices, triangles));
  } else {
    add_comments(terrain, "#", to);
  }
}

// OFF, PLY or OBJ. Throws Error, in which the file is called `name`.
void write_mesh_text(const TerrainData& terrain, const std::string& path, TinFormat format,
                     const std::string& name) {
  const Tin& tin = std::get<Tin>(terrain.surface);
  const bool is_obj = format == TinFormat::obj;
  TextFile to(path, name);
  add_header(terrain, tin, format, to);
  for (const Vec3& vertex_m : tin.vertices_m) {
    const Vec3 at = terrain.map.to_map(vertex_m);
    if (is_obj) to.add("v ");
    to.add_number(at.x);
    to.add(" ");
    to.add_number(at.y);
    to.add(" ");
    to.add_number(at.z);
    to.add("\n");
  }
  const std::uint32_t first = is_obj ? 1 : 0; // OBJ counts vertices from 1
  for (const auto& triangle : tin.triangles) {
    to.add(is_obj ? "f" : "3");
    for (const std::uint32_t vertex : triangle) {
      to.add(" ");
      to.add_number(vertex + first);
    }
    to.add("\n");
  }
  to.finish();
}

// A GeoPackage through OGR: one layer, one TIN Z.

constexpr const char* kLayerName = "tin";

// SQLite holds up to 1e9 bytes in one value, and GDAL up to 2^31; a triangle is a polygon with a
// ring of four points there.
constexpr std::uint64_t kTriangleBytes = 1 + 4 + 4 + 4 + 4 * 3 * 8;
constexpr std::uint64_t kMostTriangles = 9'000'000;
static_assert(kMostTriangles * kTriangleBytes + 1000 < 1'000'000'000);

std::unique_ptr<OGRTriangulatedSurface> geometry_of(const TerrainData& terrain, const Tin& tin) {
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
bool write(const TerrainData& terrain, const std::string& path, const GdalMessages& messages) {
  GDALDriver* const driver = GetGDALDriverManager()->GetDriverByName("GPKG");
  if (driver == nullptr) throw Error("GDAL has no GPKG here", "a GDAL that has it");
  ::unlink(path.c_str()); // the driver creates it and nothing else
  Dataset dataset(driver->Create(path.c_str(), 0, 0, 0, GDT_Unknown, nullptr));
  OGRLayer* const layer = dataset ? add_layer(*dataset, terrain.map) : nullptr;
  if (layer == nullptr) return false;
  {
    const OGRFeatureUniquePtr feature(OGRFeature::CreateFeature(layer->GetLayerDefn()));
    if (!feature) return false; // no memory for its fields
    feature->SetField("height_unit_m", terrain.map.height_unit_m);
    if (terrain.surface_error_m > 0) feature->SetField("surface_error_m", terrain.surface_error_m);
    feature->SetGeometryDirectly(geometry_of(terrain, std::get<Tin>(terrain.surface)).release());
    if (layer->CreateFeature(feature.get()) != OGRERR_NONE) return false;
  }
  dataset.reset();
  return !messages.has_failure();
}

// With one geometry that has room for every triangle.
bool is_whole(const std::string& path, std::uint64_t triangles, const GdalMessages& messages) {
  const auto enough = fmt::format("SELECT COUNT(*) FROM {} WHERE LENGTH(geom) >= {}", kLayerName,
                                  triangles * kTriangleBytes);
  return is_whole_geopackage(path, enough, "1") && !messages.has_failure();
}

void write_tin_geopackage(const TerrainData& terrain, const std::string& path,
                          const std::string& name) {
  const std::uint64_t triangles = std::get<Tin>(terrain.surface).triangles.size();
  if (triangles > kMostTriangles)
    throw Error(fmt::format("{} triangles are more than one geometry of a GeoPackage holds ({})",
                            triangles, kMostTriangles),
                "write OFF, PLY or OBJ");
  // The same bytes on any day.
  const GdalThreadOption date("OGR_CURRENT_DATE", "2000-01-01T00:00:00.000Z");
  GdalMessages messages;
  if (!write(terrain, path, messages) || !is_whole(path, triangles, messages))
    throw Error(fmt::format("{} can't be written ({})", name, messages.last_failure()),
                "a disk with room for it, and a folder that you may write to");
}

} // namespace

std::optional<TinFormat> tin_format_of(const std::string& path) {
  const std::string extension = extension_of(path);
  for (const auto& [of_format, format] :
       {std::pair(".gpkg", TinFormat::gpkg), std::pair(".off", TinFormat::off),
        std::pair(".ply", TinFormat::ply), std::pair(".obj", TinFormat::obj)})
    if (extension == of_format) return format;
  return std::nullopt;
}

void write_tin(const TerrainData& terrain, const std::string& path, TinFormat format,
               const std::string& name) {
  const std::string& called = name.empty() ? path : name;
  if (format == TinFormat::gpkg)
    write_tin_geopackage(terrain, path, called);
  else
    write_mesh_text(terrain, path, format, called);
}

} // namespace orograph
