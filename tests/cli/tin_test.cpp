// SPDX-License-Identifier: GPL-3.0-or-later
// Surveys on the command line: `orograph tin`, and drawing points and triangles.
#include "tests/catch.hpp"
#include "tests/cli/made_files.hpp"
#include "tests/cli/run_program.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

using namespace orograph;

namespace {

using Arguments = std::vector<std::string>;

const std::string points = OROGRAPH_SOURCE_DIR "/data_samples/quarry_points.csv";
const std::string breaklines = OROGRAPH_SOURCE_DIR "/data_samples/quarry_breaklines.geojson";

ProgramRun run_well(const MadeFolder& folder, const Arguments& arguments) {
  ProgramRun result = run_in(folder.path(), arguments);
  INFO(result.err);
  CHECK(result.exit_code == 0);
  return result;
}

nlohmann::json report_of(const MadeFolder& folder, Arguments arguments) {
  arguments.insert(arguments.end(), {"--report", "run.json", "--overwrite"});
  run_well(folder, arguments);
  return nlohmann::json::parse(folder.read("run.json"));
}

// The hill of made_files.hpp, without level ground.
double small_hill_m(int column, int row) {
  return hill_m(column, row, 40);
}

// From inside, with a plan that doesn't depend on the terrain's mean.
const Arguments one_view{"--eye",      "200,20,400",
                         "--look-at",  "200,200,100",
                         "--fov",      "80",
                         "--spacing",  "8m",
                         "--title",    "hill",
                         "--flat",     "draw",
                         "--layers",   "profiles,edges,border,silhouettes,skyline",
                         "--overwrite"};

} // namespace

TEST_CASE("points and breaklines are drawn, and every line asked of the ray walk is right") {
  const MadeFolder folder;
  const auto report =
      report_of(folder, {"render", points, "quarry.svg", "--breaklines", breaklines, "--check",
                         "20000", "--layers", "profiles,edges,border,silhouettes,skyline"});
  CHECK(report["input"]["surface"] == "tin");
  CHECK(report["input"]["columns"].is_null());
  CHECK(report["input"]["triangulation"]["breaklines"] == 12);
  CHECK(report["input"]["triangulation"]["points"] > 2000);
  CHECK(report["input"]["triangles"] > 4000);
  CHECK(report["check"]["asked"] >= 20000);
  CHECK(report["check"]["drawn_but_hidden"] == 0);
  CHECK(report["check"]["visible_but_not_drawn"] == 0);
  CHECK(holds(folder.read("quarry.svg"), "inkscape:label=\"2 edges\""));
}

TEST_CASE("a written TIN draws the same lines as what it was made of") {
  const MadeFolder folder;
  folder.write("hill.asc", ascii_grid(40, 40, small_hill_m));
  const auto drawing_of = [&](const std::string& file) {
    Arguments arguments{"render", file, "out.svg", "--detail", "file"};
    arguments.insert(arguments.end(), one_view.begin(), one_view.end());
    run_well(folder, arguments);
    return folder.read("out.svg");
  };
  const std::string of_grid = drawing_of("hill.asc");
  CHECK(holds(of_grid, "<path"));
  for (const char* format : {"ply", "off", "obj"}) {
    const std::string file = fmt::format("hill.{}", format);
    run_well(folder, {"tin", "hill.asc", file, "--max-error", "0m", "--height-unit", "m"});
    CAPTURE(format);
    CHECK((drawing_of(file) == of_grid));
  }
}

TEST_CASE("in every format a TIN keeps its triangles, its CRS and its bound") {
  const MadeFolder folder;
  const std::string volcano = OROGRAPH_SOURCE_DIR "/data_samples/volcano.tif";
  std::string expected;
  for (const char* format : {"gpkg", "ply", "off", "obj"}) {
    CAPTURE(format);
    const std::string file = fmt::format("volcano.{}", format);
    const ProgramRun made = run_well(folder, {"tin", volcano, file, "--max-error", "4m"});
    CHECK(holds(made.err, "Of the grid's 61 x 87 vertices"));
    const auto report = report_of(folder, {"render", file, "volcano.svg"});
    CHECK(report["input"]["crs"]["name"] == "NZGD49 / New Zealand Map Grid (EPSG:27200)");
    CHECK(report["input"]["triangles"] < 1000);
    CHECK(report["input"]["surface_error_m"] > 3);
    CHECK(report["input"]["surface_error_m"] <= 4);
    CHECK(report["error_budget_mm"]["level_of_detail"] > 0.1);
    CHECK(report["error_budget_mm"]["total"] > report["error_budget_mm"]["level_of_detail"]);
    const std::string bounds = report["input"]["triangles"].dump();
    if (expected.empty()) expected = bounds;
    CHECK(bounds == expected);
  }
}

TEST_CASE("heights in metres on a map in feet come back as they were") {
  const MadeFolder folder;
  folder.write("hill.asc", ascii_grid(40, 40, small_hill_m));
  folder.write("hill.prj", "PROJCS[\"feet\",GEOGCS[\"WGS 84\",DATUM[\"WGS_1984\",SPHEROID[\"WGS "
                           "84\",6378137,298.257223563]],PRIMEM[\"Greenwich\",0],UNIT[\"degree\","
                           "0.0174532925199433]],PROJECTION[\"Transverse_Mercator\"],PARAMETER["
                           "\"latitude_of_origin\",0],PARAMETER[\"central_meridian\",3],PARAMETER["
                           "\"scale_factor\",1],PARAMETER[\"false_easting\",0],PARAMETER["
                           "\"false_northing\",0],UNIT[\"Foot\",0.3048]]");
  for (const char* format : {"gpkg", "ply", "off", "obj"}) {
    CAPTURE(format);
    const std::string file = fmt::format("feet.{}", format);
    run_well(folder, {"tin", "hill.asc", file, "--max-error", "0m", "--height-unit", "m"});
    const auto input = report_of(folder, {"render", file, "feet.svg"})["input"];
    CHECK(input["unit_m"] == 0.3048);
    CHECK(input["height_unit_m"] == 1.0);
  }
}

TEST_CASE("what can't be a TIN is refused in one line, and nothing is written") {
  const MadeFolder folder;
  folder.write("hill.asc", ascii_grid(40, 40, small_hill_m));
  folder.write("one.csv", "x,y,z\n1,2,3\n");
  folder.write("las.laz", "LASF");
  folder.write("quad.off", "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n");
  folder.write("counts.off", "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n");
  folder.write("nan.off", "OFF\n3 1 0\n0 0 0\n1 0 nan\n1 1 0\n3 0 1 2\n");
  folder.write("huge.csv", "x,y,z\n1e200,2,3\n4,5,6\n7,1,9\n");
  folder.write("flat.geojson",
               "{\"type\":\"FeatureCollection\",\"crs\":{\"type\":\"name\",\"properties\":{"
               "\"name\":\"urn:ogc:def:crs:EPSG::32632\"}},\"features\":[{\"type\":\"Feature\","
               "\"properties\":{},\"geometry\":{\"type\":\"LineString\",\"coordinates\":[[0,0],"
               "[10,10]]}}]}");
  folder.write("other.geojson",
               "{\"type\":\"FeatureCollection\",\"crs\":{\"type\":\"name\",\"properties\":{"
               "\"name\":\"urn:ogc:def:crs:EPSG::32632\"}},\"features\":[{\"type\":\"Feature\","
               "\"properties\":{},\"geometry\":{\"type\":\"Point\",\"coordinates\":[0,0,1]}}]}");
  folder.write("empty.geojson", "{\"type\":\"FeatureCollection\",\"features\":[]}");
  struct Wrong {
    Arguments arguments;
    int exit_code;
    std::string says;
  };
  const std::vector<Wrong> wrongs{
      {{"hill.asc", "out.ply"}, 2, "--max-error"},
      {{"hill.asc", "out.svg", "--max-error", "1m"}, 2, ".gpkg, .off, .ply or .obj"},
      {{"hill.asc", "out.ply", "--max-error", "2"}, 2, "2m"},
      {{"one.csv", "out.ply"}, 1, "one.csv"},
      {{"one.csv", "out.ply", "--max-error", "1m"}, 1, "one.csv"},
      {{"las.laz", "out.ply"}, 1, "LAZ"},
      {{"quad.off", "out.ply"}, 1, "4 corners"},
      {{"counts.off", "out.ply"}, 1, "counts.off"},
      {{"nan.off", "out.ply"}, 1, "nan.off"},
      {{"huge.csv", "out.ply"}, 1, "1e+200"},
      {{"empty.geojson", "out.ply"}, 1, "empty.geojson"},
      {{points, "out.ply", "--breaklines", "flat.geojson"}, 1, "flat.geojson"},
      {{"other.geojson", "out.ply", "--breaklines", breaklines}, 1, "EPSG:32631"},
      {{points, "out.ply", "--max-edge", "0.1"}, 1, "--max-edge"},
      {{points, "out.ply", "--columns", "a,b,c"}, 1, "a"},
      {{points, points}, 2, "is an input"},
  };
  const auto before = folder.names();
  for (const Wrong& wrong : wrongs) {
    Arguments arguments = wrong.arguments;
    arguments.insert(arguments.begin(), "tin");
    const ProgramRun result = run_orograph(arguments, {.folder = folder.path()});
    CAPTURE(arguments, result.err);
    CHECK(result.exit_code == wrong.exit_code);
    CHECK(fault_of_message(result.err) == "");
    CHECK(holds(result.err, wrong.says));
    CHECK(folder.names() == before);
  }
}
