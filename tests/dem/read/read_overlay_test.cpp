// SPDX-License-Identifier: GPL-3.0-or-later
// Overlays: places where PROJ has them, what is left out, and what is refused.
#include "dem/read/lonlat.hpp"
#include "dem/read/read_overlay.hpp"
#include "tests/dem/read/refused.hpp"
#include "tests/dem/read/vector_file.hpp"
#include "tests/dem/temp_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace orograph::read_overlay_test {
namespace {

constexpr double kCell_m = 30;
// Of UTM zone 32, about 8.87 E and 46.05 N.
constexpr Box2 kTerrain{{490000, 5099000}, {491000, 5100000}};

MapFrame utm() {
  MapFrame map;
  map.crs_wkt = "EPSG:32632";
  map.crs_name = "EPSG:32632";
  return map;
}

Overlay read(const VectorFile& file, OverlayInput input = {}, const MapFrame& map = utm()) {
  const TempFolder folder;
  write_vector(file, folder.file("a.gpkg"));
  input.path = folder.file("a.gpkg");
  return read_overlay(input, map, kTerrain, kCell_m);
}

std::string refusal(const VectorFile& file, const OverlayInput& input = {}) {
  try {
    read(file, input);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

const VectorFeature kInside{"LINESTRING (490100 5099100,490900 5099900)", 7.5};

} // namespace

TEST_CASE("an overlay has a feature's lines, rings and points, and its fields") {
  const Overlay found = read({.features = {kInside,
                                           {"POINT (490500 5099500)"},
                                           {"POLYGON ((490100 5099100,490200 5099100,490200 "
                                            "5099200,490100 5099100),(490150 5099120,490160 "
                                            "5099120,490160 5099130,490150 5099120))"},
                                           {""},
                                           {"MULTILINESTRING ((490100 5099300,490200 5099300),"
                                            "(490300 5099300,490400 5099300))"}}});
  REQUIRE(found.features.size() == 4);
  CHECK(found.notes.empty());
  CHECK(found.features[0].line_count == 1);
  REQUIRE(found.features[0].attributes.size() == 1);
  CHECK(found.features[0].attributes[0] == Attribute{"height", 7.5});
  CHECK(found.features[1].attributes.empty());
  CHECK(found.lines[found.features[1].first_line].place_count == 1);
  CHECK(found.features[2].line_count == 2);
  CHECK(found.lines[found.features[2].first_line].place_count == 4);
  CHECK(found.features[3].line_count == 2);
  CHECK(found.places[0] == Vec2{490100, 5099100});
}

TEST_CASE("places of another CRS come to the terrain's, and long lines bend with it") {
  // Along a parallel, from beside the terrain to beside it: 150 km, which bends by some 600 m.
  const double lat = lonlat_of_map("EPSG:32632", kTerrain.centre()).value().y;
  VectorFile file{.features = {{fmt::format("LINESTRING (7.8 {0},9.9 {0})", lat)}}};
  file.crs = "EPSG:4326";
  const Overlay found = read(file);
  REQUIRE(found.lines.size() == 1);
  CHECK(found.places.size() > 2);
  const auto there = [&](Vec2 lonlat) { return map_of_lonlat("EPSG:32632", lonlat).value(); };
  CHECK(length(found.places.front() - there({7.8, lat})) < 1e-3);
  CHECK(length(found.places.back() - there({9.9, lat})) < 1e-3);
  double farthest_m = 0;
  for (double lon = 7.8; lon < 9.9; lon += 0.001) {
    const Vec2 at = there({lon, lat});
    double nearest_m = INFINITY;
    for (std::size_t i = 0; i + 1 < found.places.size(); ++i) {
      const Vec2 from = found.places[i], way = found.places[i + 1] - from;
      const double t = std::clamp(dot(at - from, way) / dot(way, way), 0.0, 1.0);
      nearest_m = std::min(nearest_m, length(at - from - t * way));
    }
    farthest_m = std::max(farthest_m, nearest_m);
  }
  CHECK(farthest_m < 0.1 * kCell_m);
}

TEST_CASE("places that are nowhere on earth are left out of an overlay, and don't keep it") {
  // From the coordinates of web maps to degrees GDAL's way never ended at 1e98.
  VectorFile file{.features = {{"LINESTRING (1000000 5780000,1e98 5780000)"},
                               {"LINESTRING (1000000 5780000,1001000 5780000)"}}};
  file.crs = "EPSG:3857";
  const TempFolder folder;
  write_vector(file, folder.file("a.gpkg"));
  MapFrame degrees;
  degrees.crs_wkt = degrees.crs_name = "EPSG:4326";
  const Overlay found =
      read_overlay({.path = folder.file("a.gpkg")}, degrees, {{8.9, 45.9}, {9.1, 46.1}}, 0.001);
  CHECK(found.places.size() >= 2);
  for (const Vec2 place : found.places) CHECK(std::abs(place.x - 8.99) < 0.02);
}

TEST_CASE("a line that goes over the terrain without a place on it is there") {
  const Overlay found = read({.features = {{"LINESTRING (489000 5099500,492000 5099500)"}}});
  CHECK(found.features.size() == 1);
  CHECK(refusal({.features = {{"LINESTRING (489000 5099500,489500 5099500)"}}})
            .find("is on the terrain") != std::string::npos);
}

TEST_CASE("a condition takes some of the features") {
  const VectorFile file{.features = {kInside, {"POINT (490500 5099500)", 2}}};
  CHECK(read(file, {.path = "", .layer = "", .where = "height > 5"}).features.size() == 1);
  check_message(refusal(file, {"", "", "depth > 5"}), {"no condition", "height"});
  check_message(refusal(file, {"", "", "height > 50"}), {"there is nothing", "widen"});
}

TEST_CASE("of several columns that might be coordinates the likeliest is taken, once") {
  const auto of_text = [](const std::string& text) {
    const TempFolder folder;
    const std::string path = folder.file("a.csv");
    std::ofstream(path) << text;
    return read_overlay({.path = path}, utm(), kTerrain, kCell_m);
  };
  const auto refused = [&](const std::string& text) -> std::string {
    try {
      of_text(text);
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  // GDAL alone reads through a null pointer here.
  const Overlay found = of_text("x;easting;y;name\n490100;1;5099100;hut\n");
  REQUIRE(found.places.size() == 1);
  CHECK(found.places[0] == Vec2{490100, 5099100});
  const auto& attributes = found.features[0].attributes;
  CHECK(std::ranges::find(attributes, Attribute{"name", "hut"}) != attributes.end());
  CHECK(of_text("name,n,Y,X\nhut,3,5099100,490100\n").places[0] == Vec2{490100, 5099100});
  check_message(refused("x;x;z;n\n10;20;5;5099100\n"), {"a.csv has 2 columns named x"});
  check_message(refused("lat,lon,LAT\n46,9,46\n"), {"a.csv has 2 columns named lat"});
  check_message(refused("a,b\n1,2\n"), {"no columns of coordinates"});
}

TEST_CASE("an overlay without a CRS is taken as the terrain's, and says so") {
  VectorFile file{.features = {kInside}};
  file.crs = "";
  const Overlay found = read(file);
  REQUIRE(found.notes.size() == 1);
  CHECK(found.notes[0].find("has no CRS") != std::string::npos);
  CHECK(found.places[0] == Vec2{490100, 5099100});
}

TEST_CASE("what GDAL warns of is told once, and nothing is written beside GML") {
  const TempFolder folder;
  const std::string ring =
      "<gml:featureMember><a><p><gml:Polygon><gml:outerBoundaryIs><gml:LinearRing><gml:coordinates>"
      "490100,5099100 490200,5099100 490200,5099200</gml:coordinates></gml:LinearRing>"
      "</gml:outerBoundaryIs></gml:Polygon></p></a></gml:featureMember>";
  write_text(folder.file("a.gml"),
             "<c xmlns:gml=\"http://www.opengis.net/gml\">" + ring + ring + "</c>");
  MapFrame map = utm();
  map.crs_wkt.clear();
  const Overlay found = read_overlay({.path = folder.file("a.gml")}, map, kTerrain, kCell_m);
  CHECK(found.features.size() == 2);
  REQUIRE(found.notes.size() == 1);
  check_message(found.notes[0], {"GDAL warns of", "a.gml", "Non closed ring"});
  CHECK(std::distance(std::filesystem::directory_iterator(folder.path()), {}) == 1);
}

TEST_CASE("overlays that can't be laid anywhere get a line") {
  check_message(refusal({.features = {{"POINT (0 0)"}}}), {"nothing of", "is on the terrain"});
  check_message(refusal({.features = {{""}}}), {"no feature of", "has a geometry", "points"});
  check_message(refusal({.features = {kInside}}, {"", "roads", ""}),
                {"no layer 'roads'", "survey"});
  check_message(
      [] {
        try {
          read_overlay({"no-such.gpkg", "", ""}, utm(), kTerrain, kCell_m);
        } catch (const Error& error) {
          return std::string(error.what());
        }
        return std::string();
      }(),
      {"no-such.gpkg", "vector file"});
}

} // namespace orograph::read_overlay_test
