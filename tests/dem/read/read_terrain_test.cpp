// SPDX-License-Identifier: GPL-3.0-or-later
// Which reader a file goes to, and points with the lines that belong to them.
#include "dem/read/read_terrain.hpp"
#include "tests/dem/read/raster_file.hpp"
#include "tests/dem/read/refused.hpp"
#include "tests/dem/read/tin_of_file.hpp"
#include "tests/dem/read/vector_file.hpp"

#include <cmath>

namespace orograph::read_terrain_test {
namespace {

VectorFile of(const std::string& wkt, const std::string& crs = "EPSG:32632") {
  VectorFile file;
  file.features.push_back({wkt});
  file.crs = crs;
  return file;
}

const std::string corners = "x,y,z\n0,0,1\n10,0,2\n10,10,3\n0,10,4\n";
const VectorFile corner_layer = of("MULTIPOINT Z ((0 0 1),(10 0 2),(10 10 3),(0 10 4))");
const std::string diagonal = "LINESTRING Z (0 0 1,10 10 3)";
const std::string other_diagonal = "LINESTRING Z (10 0 2,0 10 4)";

// Whether an edge of the TIN joins the two places (map coordinates).
bool has_edge(const TerrainData& terrain, Vec2 from, Vec2 to) {
  for (const auto& triangle : triangles_on_map(terrain)) {
    const auto is_corner = [&](Vec2 p) {
      return std::any_of(triangle.begin(), triangle.end(), [&](const Corner& c) {
        return std::abs(std::get<0>(c) - p.x) < 1e-9 && std::abs(std::get<1>(c) - p.y) < 1e-9;
      });
    };
    if (is_corner(from) && is_corner(to)) return true;
  }
  return false;
}

} // namespace

TEST_CASE("a raster stays what read_raster makes of it") {
  const TempFolder folder;
  write_raster(counting_raster(4, 3), folder.file("dem.tif"));
  const TerrainData terrain = read_terrain(folder.file("dem.tif"));
  REQUIRE(std::holds_alternative<Grid>(terrain.surface));
  CHECK(std::get<Grid>(terrain.surface).columns == 4);
  ReadOptions options;
  options.breaklines = folder.file("lines.gpkg");
  check_message(message_of(folder.file("dem.tif"), options), {"`breaklines`", "raster"});
}

TEST_CASE("text that GDAL takes for a grid is one, other text is points") {
  const TempFolder folder;
  write_text(folder.file("grid.asc"),
             "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 5\n1 2\n3 4\n");
  CHECK(std::holds_alternative<Grid>(read_terrain(folder.file("grid.asc")).surface));
  write_text(folder.file("rows.xyz"), "0 0 1\n10 0 2\n0 10 3\n10 10 4\n");
  CHECK(std::holds_alternative<Grid>(read_terrain(folder.file("rows.xyz")).surface));
  write_text(folder.file("scattered.xyz"), "0 0 1\n10 1 2\n3 9 3\n");
  CHECK(tin_in(read_terrain(folder.file("scattered.xyz"))).triangles.size() == 1);
  write_text(folder.file("a.CSV"), corners);
  CHECK(tin_in(read_terrain(folder.file("a.CSV"))).triangles.size() == 2);
  write_text(folder.file("a.txt"), "x y z\n0 0 1\n10 1 2\n3 9 3\n");
  CHECK(tin_in(read_terrain(folder.file("a.txt"))).triangles.size() == 1);
}

TEST_CASE("files that are nothing of all this are refused") {
  const TempFolder folder;
  check_message(message_of(folder.file("missing.tif")), {"missing.tif", "no such file"});
  check_message(message_of(folder.file("missing.csv")), {"missing.csv", "no such file"});
  check_message(message_of(folder.file("missing.laz")), {"missing.laz"});
  write_text(folder.file("words.md"), "# words\n");
  check_message(message_of(folder.file("words.md")), {"can't be opened", "GeoTIFF"});
  write_text(folder.file("words.txt"), "just words\n");
  check_message(message_of(folder.file("words.txt")), {"no column 'x'"});
  check_message(message_of(folder.path().string()), {"can't be opened"});
  write_text(folder.file("a.zip"), "no zip\n");
  check_message(message_of(folder.file("a.zip")), {"archive", "/vsizip/"});
  write_text(folder.file("a.xml"), "<svg/>\n");
  check_message(message_of(folder.file("a.xml")), {"a.xml", "can't be opened"});
}

TEST_CASE("lidar is refused with what makes text of it") {
  const TempFolder folder;
  for (const char* name : {"a.las", "a.LAZ"}) {
    write_text(folder.file(name), "LASF and so on");
    check_message(message_of(folder.file(name)), {name, "pdal translate", "X,Y,Z", "las2txt"});
  }
  // What these write is taken.
  write_text(folder.file("a.csv"), "\"X\",\"Y\",\"Z\"\n0.000,0.000,1.000\n9,0,1\n0,9,1\n");
  CHECK(tin_in(read_terrain(folder.file("a.csv"))).triangles.size() == 1);
  write_text(folder.file("a.txt"), "0.01 0.02 1.25\n9.5 0.25 1\n0 9 1\n");
  CHECK(tin_in(read_terrain(folder.file("a.txt"))).triangles.size() == 1);
}

TEST_CASE("breaklines become edges") {
  const TempFolder folder;
  write_text(folder.file("a.csv"), corners);
  write_vector(of(diagonal), folder.file("one.gpkg"));
  write_vector(of(other_diagonal), folder.file("other.gpkg"));
  ReadOptions options;
  options.breaklines = folder.file("one.gpkg");
  const TerrainData one = read_terrain(folder.file("a.csv"), options);
  CHECK(has_edge(one, {0, 0}, {10, 10}));
  REQUIRE(one.triangulation);
  CHECK(one.triangulation->breaklines == 1);
  CHECK(one.triangulation->points == 6);
  CHECK(one.source == folder.file("a.csv"));
  options.breaklines = folder.file("other.gpkg");
  CHECK(has_edge(read_terrain(folder.file("a.csv"), options), {10, 0}, {0, 10}));
  options.breaklines = folder.file("missing.gpkg");
  check_message(message_of(folder.file("a.csv"), options), {"missing.gpkg", "can't be opened"});
}

TEST_CASE("what GDAL does without in breaklines is in doubt") {
  const TempFolder folder;
  write_text(folder.file("a.csv"), "x,y,z\n0,0,1\n900,0,2\n900,900,3\n0,900,4\n");
  write_text(folder.file("lines.geojson"),
             R"({"type": "FeatureCollection", "crs": {"type": "name", "properties": )"
             R"({"name": "EPSG:999999"}}, "features": [{"type": "Feature", "properties": {}, )"
             R"("geometry": {"type": "LineString", "coordinates": [[0, 0, 1], [900, 900, 1]]}}]})");
  ReadOptions options;
  options.breaklines = folder.file("lines.geojson");
  const TerrainData terrain = read_terrain(folder.file("a.csv"), options);
  REQUIRE(terrain.doubts.size() == 1);
  check_message(terrain.doubts.front(), {"GDAL warns of", "lines.geojson", "crs not found"});
  CHECK(std::ranges::count(terrain.notes, terrain.doubts.front()) == 1);
}

TEST_CASE("a boundary cuts, and the window and the longest edge are handed on") {
  const TempFolder folder;
  write_text(folder.file("a.csv"), corners + "30,0,1\n30,10,1\n");
  ReadOptions options;
  const auto extent = [&] {
    Box2 box;
    const TerrainData terrain = read_terrain(folder.file("a.csv"), options);
    for (const Vec3& p : tin_in(terrain).vertices_m) {
      const Vec3 map = terrain.map.to_map(p);
      box.include({map.x, map.y});
    }
    return box.high.x;
  };
  CHECK(extent() == 30);
  options.max_edge_m = 15;
  CHECK(extent() == 10);
  options.max_edge_m.reset();
  options.bbox = Box2{{0, 0}, {10, 10}};
  CHECK(extent() == 10);
  options.bbox = Box2{{50, 0}, {60, 10}};
  check_message(message_of(folder.file("a.csv"), options), {"holds nothing", "from 0,0 to 30,10"});
  options.bbox.reset();
  write_vector(of("POLYGON ((0 0,20 0,20 10,0 10,0 0))", ""), folder.file("edge.gpkg"));
  options.boundary = folder.file("edge.gpkg");
  CHECK(std::abs(extent() - 20) < 1e-9);
}

TEST_CASE("a window keeps the points of lines that are inside it") {
  const TempFolder folder;
  write_vector(of("GEOMETRYCOLLECTION Z (POINT Z (0 0 1),POINT Z (99 0 1),LINESTRING Z (10 0 1,"
                  "10 10 1,50 10 1,0 10 1,0 50 1))"),
               folder.file("a.gpkg"));
  ReadOptions options;
  options.bbox = Box2{{0, 0}, {10, 10}};
  const TerrainData terrain = read_terrain(folder.file("a.gpkg"), options);
  CHECK(tin_in(terrain).vertices_m.size() == 4);
  CHECK(terrain.triangulation->breaklines == 1);
  CHECK(has_edge(terrain, {10, 0}, {10, 10}));
}

TEST_CASE("a ring with heights that leaves the window doesn't bring points from outside") {
  const TempFolder folder;
  write_vector(corner_layer, folder.file("a.gpkg"));
  write_vector(of("POLYGON Z ((5 5 9,8 5 9,50 8 9,5 8 9,5 5 9))"), folder.file("edge.gpkg"));
  ReadOptions options;
  options.boundary = folder.file("edge.gpkg");
  options.bbox = Box2{{0, 0}, {10, 10}};
  const TerrainData terrain = read_terrain(folder.file("a.gpkg"), options);
  CHECK(terrain.map.origin == Vec2{0, 10});
  for (const Vec3& p : tin_in(terrain).vertices_m) CHECK(terrain.map.to_map(p).x <= 10);
  CHECK(has_edge(terrain, {5, 8}, {5, 5}));
}

TEST_CASE("points and breaklines must be in one CRS") {
  const TempFolder folder;
  write_vector(corner_layer, folder.file("a.gpkg"));
  write_vector(of(diagonal, "EPSG:32633"), folder.file("b.gpkg"));
  ReadOptions options;
  options.breaklines = folder.file("b.gpkg");
  check_message(message_of(folder.file("a.gpkg"), options),
                {"a.gpkg", "UTM zone 32N", "b.gpkg", "UTM zone 33N", "breaklines",
                 "ogr2ogr -t_srs EPSG:32632"});
  options.boundary = folder.file("b.gpkg");
  options.breaklines.clear();
  write_vector(of("POLYGON ((0 0,9 0,9 9,0 0))", "EPSG:2229"), folder.file("c.gpkg"));
  options.boundary = folder.file("c.gpkg");
  check_message(message_of(folder.file("a.gpkg"), options), {"boundary", "EPSG:2229"});
  // Breaklines and boundary differ while the points have none.
  write_text(folder.file("a.csv"), corners);
  options.breaklines = folder.file("b.gpkg");
  check_message(message_of(folder.file("a.csv"), options), {"EPSG:32633", "EPSG:2229"});
  // The same place with heights told, too.
  write_vector(of(diagonal, "EPSG:32632+5773"), folder.file("d.gpkg"));
  options = {};
  options.breaklines = folder.file("d.gpkg");
  CHECK(message_of(folder.file("a.gpkg"), options).empty());
}

TEST_CASE("a CRS that only one file names is that of all") {
  const TempFolder folder;
  write_text(folder.file("a.csv"), corners);
  write_vector(of(diagonal, "EPSG:2229"), folder.file("feet.gpkg"));
  ReadOptions options;
  options.breaklines = folder.file("feet.gpkg");
  const TerrainData terrain = read_terrain(folder.file("a.csv"), options);
  CHECK(terrain.map.crs_name.find("EPSG:2229") != std::string::npos);
  CHECK(has_word(terrain.notes, "a.csv has no CRS: that of"));
  CHECK(!has_word(terrain.notes, "taken as metres"));
  CHECK(tin_in(terrain).vertices_m.size() == 4);
  for (const Vec3& p : tin_in(terrain).vertices_m) CHECK(std::abs(p.x) < 3.1);

  write_vector(corner_layer, folder.file("utm.gpkg"));
  write_vector(of(diagonal, ""), folder.file("none.gpkg"));
  options.breaklines = folder.file("none.gpkg");
  const TerrainData other = read_terrain(folder.file("utm.gpkg"), options);
  CHECK(other.map.crs_name.find("32632") != std::string::npos);
  CHECK(has_word(other.notes, "none.gpkg has no CRS: that of"));
}

TEST_CASE("heights in two units come together") {
  const TempFolder folder;
  write_vector(of("MULTIPOINT Z ((0 0 1),(10 0 1),(10 10 1),(0 10 1))", "EPSG:2229+5703"),
               folder.file("metres.gpkg"));
  write_vector(of("LINESTRING Z (3 3 100,6 6 100)", "EPSG:2229+6360"), folder.file("feet.gpkg"));
  ReadOptions options;
  options.breaklines = folder.file("feet.gpkg");
  const TerrainData terrain = read_terrain(folder.file("metres.gpkg"), options);
  double highest = 0;
  for (const Vec3& p : tin_in(terrain).vertices_m) highest = std::max(highest, p.z);
  CHECK(std::abs(highest - 100 * 1200. / 3937.) < 1e-9);
}

TEST_CASE("options for points are refused where there are triangles") {
  const TempFolder folder;
  write_text(folder.file("a.off"), "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  ReadOptions options;
  options.max_edge_m = 5;
  check_message(message_of(folder.file("a.off"), options), {"`max_edge_m`", "a.off", "triangles"});
}

TEST_CASE("points that make no triangle are refused by the file's name") {
  const TempFolder folder;
  write_text(folder.file("a.csv"), "x,y,z\n0,0,0\n1,1,1\n2,2,5\n");
  check_message(message_of(folder.file("a.csv")), {"a.csv"});
  write_text(folder.file("a.csv"), "x,y,z\n0,0,0\n");
  check_message(message_of(folder.file("a.csv")), {"a.csv"});
}

} // namespace orograph::read_terrain_test
