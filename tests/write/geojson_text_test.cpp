// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/error.hpp"
#include "tests/catch.hpp"
#include "write/geojson_text.hpp"

#include <nlohmann/json.hpp>
#include <ogr_spatialref.h>

#include <cmath>
#include <limits>
#include <random>

using namespace orograph;

namespace {

std::string wkt_of(const char* name) {
  OGRSpatialReference crs;
  REQUIRE(crs.SetFromUserInput(name) == OGRERR_NONE);
  char* text = nullptr;
  const char* const options[] = {"FORMAT=WKT2_2019", nullptr};
  crs.exportToWkt(&text, options);
  const std::string wkt = text;
  CPLFree(text);
  return wkt;
}

template <class Fill>
nlohmann::json written(const GeojsonText::Head& head, std::optional<int> digits, Fill&& fill) {
  std::string text;
  ByteSink out = ByteSink::into(text);
  GeojsonText geojson(head, digits, out);
  fill(geojson);
  CHECK(geojson.finish());
  out.finish();
  return nlohmann::json::parse(text);
}

} // namespace

TEST_CASE("texts and numbers come back from GeoJSON as they were") {
  std::mt19937_64 random(5);
  std::string text;
  for (char c = 1; c > 0; ++c) text += c; // all of ASCII
  text += "Ötztal \xF0\x9F\x8F\x94";
  std::string clean = text;
  for (char& c : clean)
    if (c > 0 && c < ' ' && c != '\t' && c != '\n' && c != '\r') c = '?';
  std::vector<Vec3> points;
  for (int i = 0; i < 2000; ++i) { // all bits, all magnitudes
    const auto number = [&] {
      return std::ldexp(std::uniform_real_distribution(-1.0, 1.0)(random),
                        std::uniform_int_distribution(-1000, 1000)(random));
    };
    points.push_back({number(), number(), number()});
  }
  const auto json =
      written({.name = text, .description = "\"\\", .crs_wkt = {}}, {}, [&](GeojsonText& to) {
        to.property("a \"name\"", text);
        to.property("whole", std::numeric_limits<std::int64_t>::min());
        to.property("real", 5.0);
        to.property("none", std::nan(""));
        to.property("too much", HUGE_VAL);
        CHECK(to.line(points));
        CHECK(to.line({}));
        CHECK(to.point({}));
      });
  CHECK(json["description"] == "\"\\");
  REQUIRE(json["features"].size() == 3);
  const auto& properties = json["features"][0]["properties"];
  std::string read = properties["a \"name\""];
  for (std::size_t at = 0; (at = read.find("\uFFFD", at)) != std::string::npos;)
    read.replace(at, 3, "?");
  CHECK(read == clean);
  CHECK(properties["whole"] == std::numeric_limits<std::int64_t>::min());
  CHECK(properties["real"].is_number_float());
  CHECK(properties["none"].is_null());
  CHECK(properties["too much"].is_null());
  const auto& coordinates = json["features"][0]["geometry"]["coordinates"];
  REQUIRE(coordinates.size() == points.size());
  int different = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    different += Vec3{coordinates[i][0], coordinates[i][1], coordinates[i][2]} != points[i];
  CHECK(different == 0);
  CHECK(json["features"][1]["properties"].empty());
  CHECK(json["features"][2]["geometry"].is_null());
}

TEST_CASE("points in GeoJSON have the digits that they are asked for") {
  const auto json =
      written({.name = "places", .description = {}, .crs_wkt = {}}, 3, [](GeojsonText& to) {
        to.property("height", 1234.5);
        to.point(Vec2{1.23456, -0.00098765});
      });
  CHECK(json["features"][0]["properties"]["height"] == 1230.0);
  CHECK(json["features"][0]["geometry"]["coordinates"] == nlohmann::json({1.23, -0.000988}));
  CHECK_FALSE(json.contains("crs"));
}

TEST_CASE("GeoJSON names the CRS as its specification does") {
  const auto named = [](const char* crs) -> std::string {
    const auto json =
        written({.name = "a", .description = {}, .crs_wkt = wkt_of(crs)}, {}, [](GeojsonText&) {});
    return json.contains("crs") ? json["crs"]["properties"]["name"] : "";
  };
  CHECK(named("EPSG:32632") == "urn:ogc:def:crs:EPSG::32632");
  CHECK(named("EPSG:4326") == "urn:ogc:def:crs:OGC:1.3:CRS84"); // degrees east come first
  CHECK(named("EPSG:32632+5773") == "urn:ogc:def:crs,crs:EPSG::32632,crs:EPSG::5773");
  CHECK(named("ESRI:102039") == "urn:ogc:def:crs:ESRI::102039");
  CHECK(named("+proj=tmerc +lon_0=9 +ellps=GRS80") == "");
}
