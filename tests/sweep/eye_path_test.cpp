// SPDX-License-Identifier: GPL-3.0-or-later
// A line in a vector file, and eyes along it, against the plane's geometry and GeographicLib's.
#include "dem/read/read_line.hpp"
#include "geometry/error.hpp"
#include "placing/eye_path.hpp"
#include "tests/catch.hpp"
#include "tests/support/random.hpp"
#include "tests/sweep/made_sweep.hpp"

#include <GeographicLib/Geodesic.hpp>
#include <GeographicLib/UTMUPS.hpp>
#include <fmt/format.h>

#include <cmath>
#include <filesystem>

using namespace orograph;

namespace {

std::string collection(const std::string& geometries) {
  std::string text = R"({"type":"FeatureCollection","features":[)";
  return text + geometries + "]}";
}
std::string feature(const std::string& geometry) {
  return R"({"type":"Feature","properties":{},"geometry":)" + geometry + "}";
}
std::string geometry(const std::string& type, const std::string& coordinates) {
  return R"({"type":")" + type + R"(","coordinates":)" + coordinates + "}";
}

std::string fault_of(const std::string& path) {
  try {
    read_line(path);
    return "";
  } catch (const Error& error) {
    return error.what();
  }
}

MapFrame frame_of(std::string_view crs_wkt, double unit_m = 1) {
  MapFrame map;
  map.crs_wkt = crs_wkt;
  map.unit_m = unit_m;
  return map;
}

std::string csv_line_of(const std::vector<Vec3>& points, bool has_heights) {
  std::string text = has_heights ? "id,WKT\n1,\"LINESTRING Z (" : "id,WKT\n1,\"LINESTRING (";
  for (std::size_t i = 0; i < points.size(); ++i) {
    text += fmt::format("{}{} {}", i > 0 ? "," : "", points[i].x, points[i].y);
    if (has_heights) text += fmt::format(" {}", points[i].z);
  }
  return text + ")\"\n";
}

double degrees_between(Angle a, double b_deg) {
  return std::abs(std::remainder(a.in_degrees() - b_deg, 360));
}

// Azimuth in degrees and length, on a plane.
struct Leg {
  double azimuth_deg, length_m;
};
Leg plane_leg(Vec3 a, Vec3 b) {
  return {std::atan2(b.x - a.x, b.y - a.y) * 180 / std::acos(-1.0),
          std::hypot(b.x - a.x, b.y - a.y)};
}

} // namespace

TEST_CASE("the one line of a file, whatever it is wrapped in") {
  const MadeFolder folder;
  const auto points = [&](const std::string& text) {
    const MapLine line = read_line(folder.write("a.geojson", text));
    CHECK_FALSE(line.has_heights);
    return line.points;
  };
  const std::vector<Vec3> expected{{1, 2, 0}, {3, 4, 0}, {3, 5.5, 0}};
  const std::string line = "[[1,2],[3,4],[3,5.5]]";
  CHECK(points(collection(feature(geometry("LineString", line)))) == expected);
  CHECK(points(collection(feature(geometry("MultiLineString", "[" + line + "]")))) == expected);
  CHECK(points(collection(feature("null") + "," + feature(geometry("Point", "[9,9]")) + "," +
                          feature(geometry("LineString", line)))) == expected);
  CHECK(points(collection(feature(R"({"type":"GeometryCollection","geometries":[)" +
                                  geometry("Point", "[9,9]") + "," + geometry("LineString", line) +
                                  "]}"))) == expected);

  const MapLine high = read_line(folder.write(
      "b.geojson", collection(feature(geometry("LineString", "[[1,2,30],[3,4,50]]")))));
  CHECK(high.has_heights);
  CHECK(high.points == std::vector<Vec3>{{1, 2, 30}, {3, 4, 50}});
}

TEST_CASE("the CRS of a line, where it has one") {
  const MadeFolder folder;
  const auto crs_of = [&](const std::string& name, const std::string& text) {
    return read_line(folder.write(name, text)).crs_wkt;
  };
  CHECK(crs_of("degrees.geojson", line_text("[10,46],[10.1,46]")).find("WGS 84") !=
        std::string::npos);
  CHECK(crs_of("metres.geojson", line_text("[500,46],[510,46]")) == "");
  CHECK(crs_of("north.geojson", line_text("[10,96],[10.1,46]")) == "");
  CHECK(crs_of("none.csv", "id,WKT\n1,\"LINESTRING(10 46,11 47)\"\n") == "");
  std::string utm = line_text("[500000,46],[510000,46]");
  utm.insert(1, R"("crs":{"type":"name","properties":{"name":"urn:ogc:def:crs:EPSG::32632"}},)");
  CHECK(crs_of("utm.geojson", utm).find("UTM zone 32N") != std::string::npos);
}

TEST_CASE("files without one line") {
  const MadeFolder folder;
  const auto refused = [&](const std::string& name, const std::string& text,
                           const std::string& words) {
    const std::string path = folder.write(name, text);
    const std::string fault = fault_of(path);
    INFO(name << ": " << fault);
    CHECK(fault.find(path) == 0);
    CHECK(fault.find(words) != std::string::npos);
    CHECK(fault.find('\n') == std::string::npos);
  };
  const std::string line = geometry("LineString", "[[1,2],[3,4]]");
  refused("none.geojson", collection(""), " holds no line: give a file with one line");
  refused("null.geojson", collection(feature("null")), " holds no line");
  refused("point.geojson", collection(feature(geometry("Point", "[9,9]"))), " holds no line");
  refused("ring.geojson", collection(feature(geometry("Polygon", "[[[1,2],[3,4],[3,9],[1,2]]]"))),
          " holds no line");
  refused("two.geojson", collection(feature(line) + "," + feature(line)),
          " holds more than one line: give a file with one line: ogr2ogr -where");
  refused("parts.geojson",
          collection(feature(geometry("MultiLineString", "[[[1,2],[3,4]],[[1,2],[3,4]]]"))),
          " holds more than one line");
  refused("text.geojson", "This is no JSON.", " can't be read as vectors");
  refused("empty.gpkg", "", " can't be read as vectors");
  refused("cut.gpkg", "SQLite format 3", " can't be read as vectors");
  refused("grid.asc", ascii_grid(4, 4, [](int, int) { return 1.0; }), " can't be read as vectors");
  refused("nan.csv", "id,WKT\n1,\"LINESTRING(0 0,nan 1)\"\n", "");
  CHECK(fault_of(folder.path("nowhere.gpkg")).find("nowhere.gpkg") != std::string::npos);
  std::filesystem::create_directory(folder.path("folder.gpkg"));
  CHECK(fault_of(folder.path("folder.gpkg")) != "");
}

TEST_CASE("on a plane, eyes stand at the vertices, or every step along the line") {
  const MadeFolder folder;
  Random random(8);
  for (int i = 0; i < 150; ++i) {
    const bool has_heights = random.chance(0.5);
    std::vector<Vec3> given, points; // the latter without repeated places
    const int count = random.whole(2, 7);
    for (int k = 0; k < count; ++k) {
      const Vec3 p =
          !given.empty() && random.chance(0.2)
              ? given[static_cast<std::size_t>(random.whole(0, static_cast<int>(given.size()) - 1))]
              : Vec3{random.whole(-9, 9) * 100.0, random.whole(1, 9) * 100.0,
                     random.whole(0, 500) * 1.0};
      given.push_back(p);
      if (points.empty() || points.back().x != p.x || points.back().y != p.y) points.push_back(p);
    }
    if (points.size() < 2) continue;
    const std::string path = folder.write("line.csv", csv_line_of(given, has_heights));
    const double unit_m = random.pick({1.0, 0.3048});
    const MapFrame map = frame_of("", unit_m);

    const auto at_vertices = read_eye_path(path, std::nullopt, map);
    REQUIRE(at_vertices.size() == points.size());
    double total = 0;
    for (std::size_t k = 0; k < points.size(); ++k) {
      CHECK(at_vertices[k].place.x == points[k].x);
      CHECK(at_vertices[k].place.y == points[k].y);
      REQUIRE(at_vertices[k].place.z.has_value() == has_heights);
      if (has_heights) CHECK(*at_vertices[k].place.z == points[k].z);
      const std::size_t leg = std::min(k, points.size() - 2);
      const Leg expected = plane_leg(points[leg], points[leg + 1]);
      CHECK(degrees_between(at_vertices[k].look, expected.azimuth_deg) < 1e-9);
      if (k + 1 < points.size()) total += expected.length_m;
    }

    const double step = random.pick({7.0, 100.0, 333.3, 1e5}); // in the map's unit
    const auto eyes = read_eye_path(path, step * unit_m, map);
    const double steps = total / step;
    if (std::abs(steps - std::round(steps)) > 1e-6)
      REQUIRE(eyes.size() == static_cast<std::size_t>(std::floor(steps)) + 1);
    for (std::size_t k = 0; k < eyes.size(); ++k) {
      // Walk there, leg by leg.
      double left = static_cast<double>(k) * step;
      std::size_t leg = 0;
      for (; leg + 2 < points.size(); ++leg) {
        const double length = plane_leg(points[leg], points[leg + 1]).length_m;
        if (left <= length) break;
        left -= length;
      }
      const Leg along = plane_leg(points[leg], points[leg + 1]);
      const double share = left / along.length_m;
      CHECK(std::abs(eyes[k].place.x -
                     (points[leg].x + share * (points[leg + 1].x - points[leg].x))) < 1e-8);
      CHECK(std::abs(eyes[k].place.y -
                     (points[leg].y + share * (points[leg + 1].y - points[leg].y))) < 1e-8);
      if (has_heights)
        CHECK(std::abs(*eyes[k].place.z -
                       (points[leg].z + share * (points[leg + 1].z - points[leg].z))) < 1e-8);
      if (share > 1e-9 && share < 1 - 1e-9)
        CHECK(degrees_between(eyes[k].look, along.azimuth_deg) < 1e-9);
    }
  }
}

TEST_CASE("at a corner that a step ends at, the eye looks along what follows") {
  const MadeFolder folder;
  const auto path =
      folder.write("line.csv", csv_line_of({{0, 0, 0}, {0, 90, 0}, {90, 90, 0}}, false));
  const auto eyes = read_eye_path(path, 30.0, frame_of(""));
  REQUIRE(eyes.size() == 7);
  CHECK(eyes[2].look.in_degrees() == 0);
  CHECK(eyes[3].look.in_degrees() == 90);
  CHECK(eyes[6].look.in_degrees() == 90);
  CHECK(eyes[6].place.x == 90);
  CHECK(read_eye_path(path, 1e9, frame_of("")).size() == 1);
}

TEST_CASE("on the earth, steps are as long as GeographicLib says") {
  using namespace GeographicLib;
  const MadeFolder folder;
  Random random(9);
  const Geodesic& earth = Geodesic::WGS84();
  for (int i = 0; i < 20; ++i) {
    // In longitude and latitude for a terrain in UTM zone 32.
    std::vector<Vec3> points, on_map;
    for (int k = 0; k < 4; ++k)
      points.push_back({9 + random.whole(-300, 300) / 1e4, 46 + random.whole(-300, 300) / 1e4, 0});
    std::string coordinates;
    for (const Vec3 p : points) {
      coordinates += fmt::format("{}[{},{}]", coordinates.empty() ? "" : ",", p.x, p.y);
      int zone = 0;
      bool north = false;
      double x = 0, y = 0;
      UTMUPS::Forward(p.y, p.x, zone, north, x, y, 32);
      on_map.push_back({x, y, 0});
    }
    const std::string path = folder.write("line.geojson", line_text(coordinates));
    const MapFrame map = frame_of(kUtm32);
    const auto at_vertices = read_eye_path(path, std::nullopt, map);
    REQUIRE(at_vertices.size() == points.size());
    for (std::size_t k = 0; k < points.size(); ++k) {
      CHECK(std::abs(at_vertices[k].place.x - on_map[k].x) < 1e-4);
      CHECK(std::abs(at_vertices[k].place.y - on_map[k].y) < 1e-4);
      if (k + 1 == points.size()) break;
      double azimuth = 0, back = 0;
      earth.Inverse(points[k].y, points[k].x, points[k + 1].y, points[k + 1].x, azimuth, back);
      CHECK(degrees_between(at_vertices[k].look, azimuth) < 1e-5);
    }
    const double step_m = 150;
    const auto eyes = read_eye_path(path, step_m, map);
    REQUIRE(eyes.size() > 2);
    for (std::size_t k = 0; k + 1 < eyes.size(); ++k) {
      if (eyes[k].look != eyes[k + 1].look) continue; // round a corner
      double lat[2] = {}, lon[2] = {};
      for (const std::size_t e : {0, 1})
        UTMUPS::Reverse(32, true, eyes[k + e].place.x, eyes[k + e].place.y, lat[e], lon[e]);
      double distance_m = 0;
      earth.Inverse(lat[0], lon[0], lat[1], lon[1], distance_m);
      CHECK(std::abs(distance_m - step_m) < 0.005); // the map's scale changes along a leg
    }
  }
}

TEST_CASE("paths that nobody can stand along") {
  const MadeFolder folder;
  const auto refused = [&](const std::string& name, const std::string& text,
                           std::optional<double> step_m, const std::string& words) {
    std::string fault;
    try {
      read_eye_path(folder.write(name, text), step_m, frame_of(kUtm32));
    } catch (const Error& error) {
      fault = error.what();
    }
    INFO(name << ": " << fault);
    CHECK(fault.find(words) != std::string::npos);
    CHECK(fault.find(folder.path()) == 0);
    CHECK(fault.find('\n') == std::string::npos);
  };
  refused("point.csv", "id,WKT\n1,\"LINESTRING(5 5,5 5,5 5)\"\n", std::nullopt,
          "its line has no length: a path has two places at least");
  refused("upright.csv", "id,WKT\n1,\"LINESTRING Z(5 5 1,5 5 9)\"\n", 1.0,
          "its line has no length");
  refused("empty.csv", "id,WKT\n1,\"LINESTRING EMPTY\"\n", std::nullopt, "line");
  refused("steps.csv", "id,WKT\n1,\"LINESTRING(500000 0,510000 0)\"\n", 1e-6,
          "steps of 1e-06 m make 1e+10 eyes: give a larger `step_m`");
}
