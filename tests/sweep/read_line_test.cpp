// SPDX-License-Identifier: GPL-3.0-or-later
// A line in a vector file.
#include "dem/read/read_line.hpp"
#include "geometry/error.hpp"
#include "tests/catch.hpp"
#include "tests/sweep/made_sweep.hpp"

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
