// SPDX-License-Identifier: GPL-3.0-or-later
// Written TINs, read back word by word and through OGR.
#include "dem/approximate/tin_of_grid.hpp"
#include "dem/write/write_tin.hpp"
#include "geometry/error.hpp"
#include "tests/catch.hpp"
#include "tests/dem/temp_folder.hpp"
#include "tests/support/made_grid.hpp"

#include <gdal_priv.h>
#include <ogrsf_frmts.h>
#include <sys/resource.h>

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <memory>
#include <sstream>

namespace orograph::write_tin_test {
namespace {

std::string wkt_of(int epsg) {
  OGRSpatialReference crs;
  REQUIRE(crs.importFromEPSG(epsg) == OGRERR_NONE);
  char* text = nullptr;
  crs.exportToWkt(&text);
  const std::string wkt = text;
  CPLFree(text);
  return wkt;
}

// Heights with many digits, numbers of all sizes; in feet, about an origin with decimals.
TerrainData made_terrain(int columns = 9, int rows = 7) {
  Random random(columns + 100 * rows);
  GridHeights heights;
  heights.in_double = true;
  heights.missing = 0.1;
  Tin tin = tin_of(made_grid(random, turned_lattice(columns, rows, {31.7, 20.3}, 0.3), heights));
  tin.vertices_m[0].z = 1e-310;
  tin.vertices_m[1].z = -1.7e308;
  tin.vertices_m[2].z = -0.0;
  tin.vertices_m[3].z = 1e21;
  TerrainData terrain;
  terrain.surface = std::move(tin);
  terrain.map.origin = {476543.21, 5123456.789};
  terrain.map.unit_m = 0.3048;
  terrain.map.height_unit_m = 1200.0 / 3937;
  terrain.map.crs_wkt = wkt_of(32632);
  terrain.surface_error_m = 0.1 + 0.2;
  return terrain;
}

const Tin& tin_in(const TerrainData& terrain) {
  return std::get<Tin>(terrain.surface);
}

std::string contents(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<std::string> lines_of(const std::string& path) {
  std::istringstream text(contents(path));
  std::vector<std::string> lines;
  for (std::string line; std::getline(text, line);) lines.push_back(line);
  return lines;
}

double number(const std::string& word) {
  char* end = nullptr;
  const double value = std::strtod(word.c_str(), &end);
  REQUIRE(*end == '\0');
  return value;
}

// All bits, so that -0 isn't 0.
bool same_bits(double one, double other) {
  return one == other && std::signbit(one) == std::signbit(other);
}

std::string write_within(std::uintmax_t bytes, const TerrainData& terrain, const std::string& path,
                         TinFormat format) {
  rlimit before{};
  ::getrlimit(RLIMIT_FSIZE, &before);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit limit{static_cast<rlim_t>(bytes), before.rlim_max};
  ::setrlimit(RLIMIT_FSIZE, &limit);
  std::string message = "none";
  try {
    write_tin(terrain, path, format, "my tin");
  } catch (const Error& error) {
    message = error.what();
  }
  ::setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  return message;
}

struct CloseVector {
  void operator()(GDALDataset* dataset) const { GDALClose(dataset); }
};
using Vector = std::unique_ptr<GDALDataset, CloseVector>;

Vector open_vector(const std::string& path) {
  GDALAllRegister();
  return Vector(GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY));
}

constexpr TinFormat kFormats[] = {TinFormat::gpkg, TinFormat::off, TinFormat::ply, TinFormat::obj};

} // namespace

TEST_CASE("a TIN's format is told by the extension, in any case") {
  CHECK(tin_format_of("a.gpkg") == TinFormat::gpkg);
  CHECK(tin_format_of("folder.ply/a.OFF") == TinFormat::off);
  CHECK(tin_format_of("a.b.ply") == TinFormat::ply);
  CHECK(tin_format_of("a.Obj") == TinFormat::obj);
  for (const char* other : {"", "off", "a", "a.off.gz", "a.stl", "folder.off/a"})
    CHECK_FALSE(tin_format_of(other));
}

TEST_CASE("mesh formats hold every number to the last bit, and units, CRS and error") {
  const TerrainData terrain = made_terrain();
  const Tin& tin = tin_in(terrain);
  const TempFolder folder;
  for (const TinFormat format : {TinFormat::off, TinFormat::ply, TinFormat::obj}) {
    CAPTURE(static_cast<int>(format));
    const std::string path = folder.file("tin");
    write_tin(terrain, path, format);
    const auto lines = lines_of(path);

    // The header, up to the first vertex.
    const auto comment = [&](const std::string& text) {
      std::string line = format == TinFormat::ply ? "comment" : "#";
      line += " orograph: ";
      line += text;
      return line;
    };
    std::vector<std::string> head;
    if (format == TinFormat::off) head = {"OFF"};
    if (format == TinFormat::ply) head = {"ply", "format ascii 1.0"};
    head.push_back(comment("units 0.3048 0.3048006096012192"));
    head.push_back(comment("crs " + terrain.map.crs_wkt));
    head.push_back(comment("surface_error_m 0.30000000000000004"));
    const std::string vertices = std::to_string(tin.vertices_m.size());
    const std::string triangles = std::to_string(tin.triangles.size());
    if (format == TinFormat::off) head.push_back(vertices + " " + triangles + " 0");
    if (format == TinFormat::ply)
      for (const std::string& line :
           {"element vertex " + vertices, std::string("property double x"),
            std::string("property double y"), std::string("property double z"),
            "element face " + triangles, std::string("property list uchar int vertex_indices"),
            std::string("end_header")})
        head.push_back(line);
    REQUIRE(lines.size() == head.size() + tin.vertices_m.size() + tin.triangles.size());
    for (std::size_t i = 0; i < head.size(); ++i) CHECK(lines[i] == head[i]);

    for (std::size_t i = 0; i < tin.vertices_m.size(); ++i) {
      std::istringstream line(lines[head.size() + i]);
      std::string x, y, z, more;
      if (format == TinFormat::obj) {
        line >> x;
        REQUIRE(x == "v");
      }
      line >> x >> y >> z;
      REQUIRE_FALSE(line >> more);
      const Vec3 expected = terrain.map.to_map(tin.vertices_m[i]);
      REQUIRE(same_bits(number(x), expected.x));
      REQUIRE(same_bits(number(y), expected.y));
      REQUIRE(same_bits(number(z), expected.z));
    }
    for (std::size_t i = 0; i < tin.triangles.size(); ++i) {
      const std::uint32_t first = format == TinFormat::obj ? 1 : 0;
      std::string expected = format == TinFormat::obj ? "f" : "3";
      for (const std::uint32_t v : tin.triangles[i]) {
        expected += ' ';
        expected += std::to_string(v + first);
      }
      REQUIRE(lines[head.size() + tin.vertices_m.size() + i] == expected);
    }
  }
}

TEST_CASE("without CRS and error only the units are commented, and a CRS takes one line") {
  const TempFolder folder;
  TerrainData terrain = made_terrain();
  terrain.map = {};
  terrain.surface_error_m = 0;
  write_tin(terrain, folder.file("tin.off"), TinFormat::off);
  const auto lines = lines_of(folder.file("tin.off"));
  CHECK(lines[1] == "# orograph: units 1 1");
  CHECK(lines[2].find('#') == std::string::npos);

  terrain.map.crs_wkt = "LOCAL_CS[\"here\",\r\n  UNIT[\"metre\",1]]";
  write_tin(terrain, folder.file("tin.off"), TinFormat::off);
  CHECK(lines_of(folder.file("tin.off"))[2] ==
        "# orograph: crs LOCAL_CS[\"here\",    UNIT[\"metre\",1]]");
}

TEST_CASE("a GeoPackage holds one TIN Z to the last bit, in its CRS") {
  const TerrainData terrain = made_terrain();
  const Tin& tin = tin_in(terrain);
  const TempFolder folder;
  const std::string path = folder.file("tin.gpkg");
  write_tin(terrain, path, TinFormat::gpkg);

  const Vector dataset = open_vector(path);
  REQUIRE(dataset);
  REQUIRE(dataset->GetLayerCount() == 1);
  OGRLayer* const layer = dataset->GetLayerByName("tin");
  REQUIRE(layer);
  CHECK(layer->GetGeomType() == wkbTINZ);
  CHECK(layer->GetFeatureCount() == 1);
  OGRSpatialReference crs(terrain.map.crs_wkt.c_str());
  REQUIRE(layer->GetSpatialRef());
  CHECK(layer->GetSpatialRef()->IsSame(&crs));

  const OGRFeatureUniquePtr feature(layer->GetNextFeature());
  CHECK(feature->GetFieldAsDouble("surface_error_m") == terrain.surface_error_m);
  CHECK(feature->GetFieldAsDouble("height_unit_m") == terrain.map.height_unit_m);
  const OGRGeometry* const geometry = feature->GetGeometryRef();
  REQUIRE(geometry->getGeometryType() == wkbTINZ);
  const OGRTriangulatedSurface* const surface = geometry->toTriangulatedSurface();
  REQUIRE(surface->getNumGeometries() == static_cast<int>(tin.triangles.size()));
  for (int t = 0; t < surface->getNumGeometries(); ++t) {
    const OGRLinearRing* const ring = surface->getGeometryRef(t)->getExteriorRing();
    REQUIRE(ring->getNumPoints() == 4);
    for (int k = 0; k < 4; ++k) {
      const std::uint32_t v =
          tin.triangles[static_cast<std::size_t>(t)][static_cast<std::size_t>(k % 3)];
      const Vec3 expected = terrain.map.to_map(tin.vertices_m[v]);
      REQUIRE(same_bits(ring->getX(k), expected.x));
      REQUIRE(same_bits(ring->getY(k), expected.y));
      REQUIRE(same_bits(ring->getZ(k), expected.z));
    }
  }
}

TEST_CASE("a GeoPackage without CRS and error has neither") {
  TerrainData terrain = made_terrain();
  terrain.map = {};
  terrain.surface_error_m = 0;
  const TempFolder folder;
  write_tin(terrain, folder.file("tin.gpkg"), TinFormat::gpkg);
  const Vector dataset = open_vector(folder.file("tin.gpkg"));
  OGRLayer* const layer = dataset->GetLayer(0);
  REQUIRE(layer->GetSpatialRef());
  CHECK(std::string(layer->GetSpatialRef()->GetName()) == "Undefined Cartesian SRS");
  CHECK_FALSE(layer->GetSpatialRef()->IsGeographic());
  const OGRFeatureUniquePtr feature(layer->GetNextFeature());
  CHECK_FALSE(feature->IsFieldSetAndNotNull(feature->GetFieldIndex("surface_error_m")));
  CHECK(feature->GetFieldAsDouble("height_unit_m") == 1);
}

TEST_CASE("a TIN is written over what was there, the same bytes each time, nothing beside it") {
  const TerrainData terrain = made_terrain();
  for (const TinFormat format : kFormats) {
    CAPTURE(static_cast<int>(format));
    const TempFolder folder;
    const std::string path = folder.file("tin.gpkg");
    std::ofstream(path) << std::string(1000000, 'x');
    write_tin(terrain, path, format);
    const std::string first = contents(path);
    CHECK(first.size() < 1000000);
    write_tin(terrain, path, format);
    CHECK(contents(path) == first);
    CHECK(std::distance(std::filesystem::directory_iterator(folder.path()), {}) == 1);
  }
}

TEST_CASE("a full disk is an error wherever it fills up, and so is a missing folder") {
  const TerrainData terrain = made_terrain(40, 60);
  for (const TinFormat format : kFormats) {
    CAPTURE(static_cast<int>(format));
    const TempFolder folder;
    const std::string path = folder.file("tin.gpkg");
    write_tin(terrain, path, format);
    const std::uintmax_t whole = std::filesystem::file_size(path);
    for (int i = 0; i < 12; ++i) {
      std::filesystem::remove(path);
      const std::uintmax_t bytes = i == 11 ? whole - 1 : whole * static_cast<unsigned>(i) / 11;
      CAPTURE(whole, bytes);
      CHECK_THAT(write_within(bytes, terrain, path, format),
                 Catch::Contains("my tin can't be written (") &&
                     Catch::Contains("): a disk with room"));
    }
    CHECK_THROWS_AS(write_tin(terrain, folder.file("no/tin.gpkg"), format), Error);
  }
}

} // namespace orograph::write_tin_test
