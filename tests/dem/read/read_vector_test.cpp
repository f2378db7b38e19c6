// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/read/map_shapes.hpp"
#include "tests/dem/read/refused.hpp"
#include "tests/dem/read/tin_of_file.hpp"
#include "tests/dem/read/vector_file.hpp"

#include <fmt/format.h>

#include <cmath>
#include <tuple>

namespace orograph::read_vector_test {
namespace {

const std::string lower = "((0 0 1,10 0 2,10 10 3.5,0 0 1))";
const std::string upper = "((0 0 1,10 10 3.5,0 10 4,0 0 1))";
const std::vector<std::array<Corner, 3>> square{
    {Corner{0, 0, 1}, Corner{10, 0, 2}, Corner{10, 10, 3.5}},
    {Corner{0, 0, 1}, Corner{10, 10, 3.5}, Corner{0, 10, 4}}};

VectorFile of(const std::vector<std::string>& wkts) {
  VectorFile file;
  for (const std::string& wkt : wkts) file.features.push_back({wkt});
  return file;
}

TerrainData read_back(const VectorFile& file, const std::string& name = "a.gpkg",
                      const ReadOptions& options = {}) {
  const TempFolder folder;
  write_vector(file, folder.file(name));
  return read_terrain(folder.file(name), options);
}

MapShapes shapes_in(const VectorFile& file, VectorUse use, const ReadOptions& options = {}) {
  const TempFolder folder;
  write_vector(file, folder.file("a.gpkg"));
  return read_vector(folder.file("a.gpkg"), use, options);
}

void refused(const VectorFile& file, const std::vector<std::string>& words,
             const ReadOptions& options = {}, const std::string& name = "a.gpkg") {
  const TempFolder folder;
  write_vector(file, folder.file(name));
  std::vector<std::string> all = words;
  all.push_back(name);
  check_message(message_of(folder.file(name), options), all);
}

void refused_as(const VectorFile& file, VectorUse use, const std::vector<std::string>& words) {
  std::string message;
  try {
    shapes_in(file, use);
  } catch (const Error& error) {
    message = error.what();
  }
  check_message(message, words);
}

ReadOptions by_field(const std::string& name) {
  ReadOptions options;
  options.height_field = name;
  return options;
}

} // namespace

TEST_CASE("triangles in every geometry that can hold them") {
  for (const auto& wkts : std::vector<std::vector<std::string>>{
           {"TIN Z (" + lower + "," + upper + ")"},
           {"POLYHEDRALSURFACE Z (" + lower + "," + upper + ")"},
           {"POLYGON Z " + lower, "POLYGON Z " + upper},
           {"MULTIPOLYGON Z (" + lower + "," + upper + ")"},
           {"TRIANGLE Z " + lower, "", "POLYGON Z EMPTY", "TRIANGLE Z " + upper},
           {"GEOMETRYCOLLECTION Z (TIN Z (" + lower + "),POLYGON Z " + upper + ")"},
           {"POLYGON ZM ((0 0 1 5,10 0 2 5,10 10 3.5 5,0 0 1 5))", "POLYGON Z " + upper},
           // A face of four corners whose last repeats, as DXF has it.
           {"POLYGON Z ((0 0 1,10 0 2,10 10 3.5,10 10 3.5,0 0 1))", "POLYGON Z " + upper}}) {
    INFO(wkts[0]);
    const TerrainData terrain = read_back(of(wkts));
    CHECK(triangles_on_map(terrain) == square);
    CHECK(terrain.map.crs_name == "WGS 84 / UTM zone 32N (EPSG:32632)");
    CHECK(terrain.map.origin == Vec2{0, 10});
  }
}

TEST_CASE("triangles in every common format") {
  for (const auto& [driver, name] :
       std::vector<std::pair<std::string, std::string>>{{"GPKG", "a.gpkg"},
                                                        {"GeoJSON", "a.geojson"},
                                                        {"FlatGeobuf", "a.fgb"},
                                                        {"ESRI Shapefile", "a.shp"}}) {
    INFO(driver);
    VectorFile file = of({"POLYGON Z " + lower, "POLYGON Z " + upper});
    file.driver = driver;
    const TerrainData terrain = read_back(file, name);
    CHECK(triangles_on_map(terrain) == square);
    CHECK(terrain.map.crs_name.find("UTM zone 32N") != std::string::npos);
  }
}

TEST_CASE("faces of a DXF drawing") {
  const auto face = [](const std::vector<Vec3>& corners) {
    std::string text = "0\n3DFACE\n8\n0\n";
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Vec3 p = corners[i];
      for (const auto& [code, value] : {std::pair{10, p.x}, {20, p.y}, {30, p.z}})
        text += std::to_string(code + int(i)) + "\n" + std::to_string(value) + "\n";
    }
    return text;
  };
  const std::string begin = "0\nSECTION\n2\nENTITIES\n", end = "0\nENDSEC\n0\nEOF\n";
  const TempFolder folder;
  write_text(folder.file("a.dxf"),
             begin + face({{0, 0, 1}, {10, 0, 2}, {10, 10, 3.5}, {10, 10, 3.5}}) +
                 face({{0, 0, 1}, {10, 10, 3.5}, {0, 10, 4}, {0, 10, 4}}) + end);
  const TerrainData terrain = read_terrain(folder.file("a.dxf"));
  CHECK(triangles_on_map(terrain) == square);
  CHECK(has_word(terrain.notes, "no CRS"));
  write_text(folder.file("b.dxf"),
             begin + face({{0, 0, 1}, {10, 0, 2}, {10, 10, 3.5}, {0, 10, 4}}) + end);
  check_message(message_of(folder.file("b.dxf")), {"feature", "4 corners", "Tessellate"});
}

TEST_CASE("a field tells how far the surface may be off") {
  VectorFile file = of({"POLYGON Z " + lower, "POLYGON Z " + upper});
  file.features[0].surface_error_m = 2.5;
  CHECK(read_back(file).surface_error_m == 2.5);
  file.features[0].surface_error_m = -1;
  refused(file, {"feature 1", "surface_error_m"});
}

TEST_CASE("polygons that aren't triangles are refused with a hint") {
  refused(of({"POLYGON Z " + lower, "POLYGON Z ((0 0 1,10 0 1,10 10 1,0 10 1,0 0 1))"}),
          {"feature 2", "4 corners", "triangles"});
  refused(of({"POLYGON Z ((0 0 1,9 0 1,9 9 1,0 0 1),(4 1 1,5 1 1,5 2 1,4 1 1))"}),
          {"feature 1", "hole"});
  refused(of({"POLYGON ((0 0,10 0,10 10,0 0))"}), {"feature 1", "without heights", "-zfield"});
  refused(of({"POLYGON Z ((0 0 1,10 0 -12345,10 10 1,0 0 1))"}), {"feature 1", "nan", "10, 0"});
  refused(of({"POLYGON Z ((0 0 1,10 0 1e20,10 10 1,0 0 1))"}), {"1e+20", "no place on earth"});
  refused(of({"CURVEPOLYGON Z (CIRCULARSTRING Z (0 0 1,1 1 1,2 0 1,1 -1 1,0 0 1))"}),
          {"feature 1", "curves", "CONVERT_TO_LINEAR"});
  refused(of({"POLYGON Z " + lower, "POINT Z (1 1 1)"}), {"'survey'", "triangles beside points"});
  refused(of({"POLYGON Z " + lower, "LINESTRING Z (1 1 1,2 2 2)"}), {"triangles beside points"});
}

TEST_CASE("points take their heights from Z or from a field") {
  const std::vector<Vec3> wanted{{0, 0, 1}, {10, 0, 2}, {0, 10, 3}};
  const auto points = [](const VectorFile& file, const ReadOptions& options = {}) {
    return shapes_in(file, VectorUse::terrain, options).points;
  };
  CHECK(points(of({"POINT Z (0 0 1)", "MULTIPOINT Z ((10 0 2),(0 10 3))"})) == wanted);
  VectorFile flat = of({"POINT (0 0)", "POINT (10 0)", "MULTIPOINT ((0 10))"});
  for (std::size_t i = 0; i < 3; ++i) flat.features[i].height = 1. + double(i);
  CHECK(points(flat, by_field("height")) == wanted);
  CHECK(points(flat, by_field("HEIGHT")) == wanted);
  CHECK(tin_in(read_back(flat, "a.gpkg", by_field("height"))).triangles.size() == 1);
  // The field that is named counts more than Z.
  VectorFile both = of({"POINT Z (0 0 99)"});
  both.features[0].height = 1;
  CHECK(points(both, by_field("height")) == std::vector<Vec3>{{0, 0, 1}});

  refused(flat, {"feature 1", "without a height", "`height_field`"});
  refused(flat, {"no field 'z'", "height, surface_error_m"}, by_field("z"));
  flat.features[1].height.reset();
  refused(flat, {"feature 2", "no height in the field 'height'"}, by_field("height"));
  flat.features[1].height = std::numeric_limits<double>::infinity();
  refused(flat, {"feature 2", "inf"}, by_field("height"));
  flat.height_type = "String";
  refused(flat, {"'height' holds no numbers", "CAST"}, by_field("height"));
  refused(of({"POINT Z (0 0 1)", "POINT Z (1 0 -12345)"}), {"feature 2", "nan"});
}

TEST_CASE("lines beside points are breaklines") {
  const MapShapes shapes = shapes_in(of({"POINT Z (0 9 1)", "LINESTRING Z (0 0 1,5 5 2,9 9 3)",
                                         "MULTILINESTRING Z ((1 0 1,2 0 2),(3 0 1,4 0 2))"}),
                                     VectorUse::terrain);
  CHECK(shapes.points == std::vector<Vec3>{{0, 9, 1}});
  REQUIRE(shapes.breaklines.size() == 3);
  CHECK(shapes.breaklines[0] == std::vector<Vec3>{{0, 0, 1}, {5, 5, 2}, {9, 9, 3}});
  refused_as(of({"LINESTRING (0 0,1 1)"}), VectorUse::breaklines,
             {"feature 1", "without heights", "-zfield"});
  refused_as(of({"LINESTRING Z (0 0 1,1 1 -12345)"}), VectorUse::breaklines, {"feature 1", "nan"});
  refused_as(of({"POINT Z (0 0 1)"}), VectorUse::breaklines, {"feature 1", "lines"});
  refused_as(of({"POLYGON Z " + lower}), VectorUse::breaklines, {"feature 1", "MULTILINESTRING"});
  refused_as(of({"COMPOUNDCURVE Z ((0 0 1,1 1 1))"}), VectorUse::breaklines, {"curves"});
}

TEST_CASE("rings of a boundary have all their heights or none") {
  const auto rings = [](const std::string& wkt) {
    return shapes_in(of({wkt}), VectorUse::boundary).rings;
  };
  const auto with = rings("POLYGON Z ((0 0 1,9 0 2,9 9 3,0 0 1),(4 1 1,5 1 1,5 2 1,4 1 1))");
  REQUIRE(with.size() == 2);
  CHECK(with[0] == std::vector<Vec3>{{0, 0, 1}, {9, 0, 2}, {9, 9, 3}});
  for (const char* wkt : {"POLYGON ((0 0,9 0,9 9,0 0))", "MULTIPOLYGON (((0 0,9 0,9 9,0 0)))",
                          "POLYGON Z ((0 0 1,9 0 -12345,9 9 3,0 0 1))"}) {
    const auto without = rings(wkt);
    REQUIRE(without.size() == 1);
    REQUIRE(without[0].size() == 3);
    for (const Vec3& p : without[0]) CHECK(std::isnan(p.z));
    CHECK(without[0][1].x == 9);
  }
  refused_as(of({"LINESTRING (0 0,1 1,1 0,0 0)"}), VectorUse::boundary,
             {"feature 1", "polygons", "-nlt POLYGON"});
  refused_as(of({"POLYGON ((0 0,1 1,0 0))"}), VectorUse::boundary, {"feature 1", "2 points"});
}

TEST_CASE("one layer of several is picked by name") {
  const TempFolder folder;
  VectorFile file = of({"POLYGON Z " + lower, "POLYGON Z " + upper});
  file.layer = "old";
  write_vector(file, folder.file("a.gpkg"));
  file.layer = "new";
  file.append = true;
  file.features.pop_back();
  write_vector(file, folder.file("a.gpkg"));
  ReadOptions options;
  check_message(message_of(folder.file("a.gpkg")), {"2 layers: old, new", "`layer`"});
  options.layer = "old";
  CHECK(tin_in(read_terrain(folder.file("a.gpkg"), options)).triangles.size() == 2);
  options.layer = "new";
  CHECK(tin_in(read_terrain(folder.file("a.gpkg"), options)).triangles.size() == 1);
  options.layer = "newer";
  check_message(message_of(folder.file("a.gpkg"), options), {"'newer'", "old, new"});
}

TEST_CASE("layers without anything are refused") {
  refused(of({}), {"'survey'", "empty"});
  refused(of({"", "POINT Z EMPTY"}), {"'survey'", "empty"});
  CHECK(has_word(read_back(of({"", "POLYGON Z " + lower})).notes, "1 of the features"));
}

TEST_CASE("the unit of a vector file's heights") {
  VectorFile file = of({"POLYGON Z " + lower});
  CHECK(has_word(read_back(file).notes, "no unit of height: that of its CRS is taken, metre"));
  file.crs = "EPSG:2229";
  const TerrainData feet = read_back(file);
  CHECK(std::abs(feet.map.height_unit_m - 1200. / 3937.) < 1e-12);
  CHECK(feet.map.height_unit_name == "US survey foot");
  CHECK(std::abs(tin_in(feet).vertices_m[0].z - 1200. / 3937.) < 1e-12);
  file.crs = "EPSG:2229+5703"; // NAVD88 heights in metres
  const TerrainData compound = read_back(file);
  CHECK(compound.map.height_unit_m == 1);
  CHECK(!has_word(compound.notes, "unit of height"));
  file.crs = "LOCAL_CS[\"site grid\",UNIT[\"foot\",0.3048]]";
  const TerrainData local = read_back(file);
  CHECK(local.map.unit_m == 0.3048);
  CHECK(local.map.crs_name == "site grid");
  file.crs.clear();
  const TerrainData none = read_back(file);
  CHECK(none.map.crs_name == "none");
  CHECK(none.map.crs_wkt.empty());
  CHECK(has_word(none.notes, "taken as metres"));
}

TEST_CASE("degrees are refused, and what GeoJSON only takes for degrees isn't") {
  VectorFile file = of({"POLYGON Z ((6 46 1,7 46 2,7 47 3.5,6 46 1))"});
  file.crs = "EPSG:4326";
  refused(file, {"degrees", "rasters only", "ogr2ogr -t_srs EPSG:32632"});
  const auto triangle_at = [](double lon, double lat) {
    return of({fmt::format("POLYGON Z (({0} {1} 1,{2} {1} 2,{2} {3} 3,{0} {1} 1))", lon, lat,
                           lon + 0.1, lat + 0.1)});
  };
  const std::tuple<double, double, const char*> zones[] = {{18.3, -33.9, "EPSG:32734"},
                                                           {235, 48, "EPSG:32610"},
                                                           {-179.9, -10, "EPSG:32701"},
                                                           {179.7, 10, "EPSG:32660"},
                                                           {10, 86, "EPSG:32661"}};
  for (const auto& [lon, lat, fitting] : zones) {
    VectorFile there = triangle_at(lon, lat);
    there.crs = "EPSG:4326";
    refused(there, {fitting});
  }
  const TempFolder folder;
  const auto geojson = [&](const std::string& coordinates) {
    write_text(folder.file("a.geojson"),
               R"({"type":"Feature","properties":{},"geometry":{"type":"Polygon","coordinates":[)" +
                   coordinates + "]}}");
    return folder.file("a.geojson");
  };
  check_message(message_of(geojson("[[6,46,1],[7,46,2],[7,47,3],[6,46,1]]")),
                {"a.geojson", "degrees"});
  const TerrainData local =
      read_terrain(geojson("[[4000,3000,1],[5000,3000,2],[5000,4000,3],[4000,3000,1]]"));
  CHECK(local.map.crs_name == "none");
  CHECK(has_word(local.notes, "no CRS"));
  check_message(message_of(geojson("[[4000,3000,1],[5000,")), {"a.geojson"});
}

TEST_CASE("a truncated vector file is refused") {
  const TempFolder folder;
  write_vector(of({"POLYGON Z " + lower}), folder.file("a.gpkg"));
  std::filesystem::resize_file(folder.file("a.gpkg"), 5000);
  check_message(message_of(folder.file("a.gpkg")), {"a.gpkg"});
  write_text(folder.file("b.geojson"), "not json");
  check_message(message_of(folder.file("b.geojson")), {"b.geojson", "can't be opened"});
}

} // namespace orograph::read_vector_test
