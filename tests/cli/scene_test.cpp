// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes through the program: bytes, places, layers, reports.
#include "cli/options/options.hpp"
#include "cli/render.hpp"
#include "tests/catch.hpp"
#include "tests/cli/made_files.hpp"
#include "tests/cli/made_scenes.hpp"
#include "tests/cli/run_program.hpp"

#include <GeographicLib/LocalCartesian.hpp>
#include <nlohmann/json.hpp>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <sstream>

using namespace orograph;
using Json = nlohmann::json;

namespace {

constexpr int kSize = 40;
double small_hill_m(int column, int row) {
  return hill_m(column, row, kSize);
}

void make_inputs(const MadeFolder& folder) {
  folder.write("hill.asc", ascii_grid(kSize, kSize, small_hill_m));
  folder.write("alps.asc",
               ascii_grid(kSize, kSize, small_hill_m, {.x = 10, .y = 46, .cell = 0.001}));
  folder.write("alps.prj", "GEOGCS[\"WGS 84\",DATUM[\"WGS_1984\",SPHEROID[\"WGS 84\",6378137,"
                           "298.257223563]],PRIMEM[\"Greenwich\",0],"
                           "UNIT[\"degree\",0.0174532925199433]]");
  make_scenes(folder);
  std::string many = scene_text("part = 'box'\nat = [200, 200]");
  for (int i = 0; i < 40; ++i) {
    std::ostringstream place;
    place << "[[place]]\npart = '" << (i % 3 == 0 ? "mast" : "box") << "'\nat = ["
          << 20 + 47 * i % 360 << ", " << 20 + 71 * i % 360 << "]\nmap = [{ turn_z = " << 31 * i
          << " }]\n";
    many += place.str();
  }
  folder.write("many.toml", many);
}

ProgramRun run_line(const MadeFolder& folder, const std::string& arguments) {
  std::istringstream words(arguments);
  return run_orograph({std::istream_iterator<std::string>(words), {}}, {.folder = folder.path()});
}

void run_line_well(const MadeFolder& folder, const std::string& arguments) {
  const ProgramRun ended = run_line(folder, arguments);
  INFO("orograph " << arguments << "\n" << ended.err);
  REQUIRE(ended.exit_code == 0);
}

std::vector<Json> strokes_of(const MadeFolder& folder, const std::string& name,
                             const std::string& layer) {
  std::vector<Json> found;
  const Json json = Json::parse(folder.read(name));
  for (const Json& feature : json["features"])
    if (feature["properties"]["layer"] == layer) found.push_back(feature);
  return found;
}

// How far from the nearest point of any stroke, by the greatest of the three differences over
// `per_unit`.
double distance_to(const std::vector<Json>& strokes, const std::array<double, 3>& place,
                   const std::array<double, 3>& per_unit) {
  double nearest = 1e300;
  for (const Json& stroke : strokes)
    for (const Json& point : stroke["geometry"]["coordinates"]) {
      double farthest = 0;
      for (std::size_t i = 0; i < 3; ++i)
        farthest = std::max(farthest, std::abs(point[i].get<double>() - place[i]) / per_unit[i]);
      nearest = std::min(nearest, farthest);
    }
  return nearest;
}

// NaN and infinity are written as null.
void check_no_null(const Json& numbers) {
  for (const auto& [key, value] : numbers.items()) {
    INFO(key);
    CHECK(value.is_number());
  }
}

} // namespace

TEST_CASE("solids are drawn the same by one core, by several, and every time", "[slow]") {
  const MadeFolder folder;
  make_inputs(folder);
  for (const std::string input : {"hill.asc", "alps.asc", "many.toml"})
    for (const std::string extension : {"svg", "pdf", "geojson"}) {
      std::vector<std::string> bytes;
      for (const std::size_t threads : {1, 2, 2, 5}) {
        const tbb::global_control cores(tbb::global_control::max_allowed_parallelism, threads);
        const std::string output = "out." + extension;
        std::vector<std::string> arguments{
            folder.path(input), folder.path(output), "--hidden", "dash", "--overwrite", "-q"};
        if (input == "hill.asc")
          arguments.insert(arguments.end(), {"--scene", folder.path("many.toml")});
        if (input == "alps.asc")
          arguments.insert(arguments.end(), {"--scene", folder.path("in-degrees.toml")});
        folder.write("in-degrees.toml", scene_text("part = 'box'\nat = [10.02, 46.02]\nmap = [{ "
                                                   "scale = 20 }]"));
        render(parse_render(arguments).value());
        bytes.push_back(folder.read(output));
      }
      INFO(input << " " << extension);
      CHECK(bytes.front().size() > 500);
      for (const std::string& again : bytes) CHECK(again == bytes.front());
    }
}

TEST_CASE("vertices of a solid are in the map's coordinates where the scene put them") {
  const MadeFolder folder;
  make_inputs(folder);
  folder.write("high.toml", scene_text("part = 'box'\nat = [200, 200, 500]"));
  for (const std::string exaggeration : {"1", "3"}) {
    run_line_well(folder, "render hill.asc out.geojson --scene high.toml --hidden dash --overwrite "
                          "--exaggeration " +
                              exaggeration);
    const auto visible = strokes_of(folder, "out.geojson", "solids");
    std::vector<Json> all = strokes_of(folder, "out.geojson", "hidden");
    for (const Json& stroke : all) CHECK(stroke["properties"]["visible"] == 0);
    for (const Json& stroke : visible) CHECK(stroke["properties"]["visible"] == 1);
    CHECK(!visible.empty());
    CHECK(!all.empty());
    all.insert(all.end(), visible.begin(), visible.end());
    for (const double x : {190.0, 210.0})
      for (const double y : {190.0, 210.0})
        for (const double z : {500.0, 530.0}) CHECK(distance_to(all, {x, y, z}, {1, 1, 1}) < 1e-6);
  }
}

TEST_CASE("a solid stands upright on the ellipsoid, in true heights") {
  const MadeFolder folder;
  make_inputs(folder);
  folder.write("high.toml", scene_text("part = 'box'\nlonlat = [10.03, 46.01, 500]"));
  const GeographicLib::LocalCartesian there(46.01, 10.03, 500);
  for (const std::string exaggeration : {"1", "3"}) {
    run_line_well(folder, "render alps.asc out.geojson --scene high.toml --hidden dash --overwrite "
                          "--exaggeration " +
                              exaggeration);
    std::vector<Json> all = strokes_of(folder, "out.geojson", "hidden");
    const auto visible = strokes_of(folder, "out.geojson", "solids");
    all.insert(all.end(), visible.begin(), visible.end());
    for (const double x : {-10.0, 10.0})
      for (const double y : {-10.0, 10.0})
        for (const double z : {0.0, 30.0}) {
          double lat = 0, lon = 0, height = 0;
          there.Reverse(x, y, z, lat, lon, height);
          // Metres stay metres where they are lifted to: a box of 20 m 1000 m higher is 2 mm off.
          CHECK(distance_to(all, {lon, lat, height}, {1e-5, 1e-5, 1}) <
                1e-3 * std::stod(exaggeration));
        }
  }
}

TEST_CASE("hidden edges are dashes on the page, and whole lines on the map") {
  const MadeFolder folder;
  make_inputs(folder);
  run_line_well(folder, "render hut.toml out.geojson --hidden dash");
  // Of a box from above its side: six faces, three seen; three edges meet behind.
  CHECK(strokes_of(folder, "out.geojson", "hidden").size() <= 3);
  run_line_well(folder, "render hut.toml out.svg --hidden dash");
  const std::string svg = folder.read("out.svg");
  const auto layer = svg.find(" hidden\" fill=");
  REQUIRE(layer != std::string::npos);
  const std::string hidden = svg.substr(layer, svg.find("</g>", layer) - layer);
  CHECK(std::count(hidden.begin(), hidden.end(), 'M') > 20);
  run_line_well(folder, "render hut.toml plain.svg");
  CHECK(folder.read("plain.svg").find(" hidden\" fill=") == std::string::npos);
}

TEST_CASE("a report tells how many solids there are, and of a scene alone nothing that isn't") {
  const MadeFolder folder;
  make_inputs(folder);
  const auto report_of = [&](const std::string& arguments) {
    run_line_well(folder, "render " + arguments + " out.svg --overwrite --report out.json");
    return Json::parse(folder.read("out.json"));
  };
  const Json on_hill = report_of("hill.asc --scene many.toml");
  CHECK(on_hill["input"]["surface"] == "grid");
  CHECK(on_hill["input"]["scene"] == "many.toml");
  CHECK(on_hill["counts"]["solids"] == 41);
  CHECK(on_hill["counts"]["solid_edges"] == 27 * 18 + 14); // boxes with their faces' diagonals
  const Json alone = report_of("hut.toml");
  CHECK(alone["input"]["surface"] == "none");
  CHECK(alone["input"]["scene"] == "hut.toml");
  CHECK(alone["input"]["vertices"].is_null());
  CHECK(alone["counts"]["solids"] == 1);
  CHECK(alone["profiles"]["count"] == 0);
  CHECK(alone["view"]["look_at"] == Json({200, 200, 15}));
  for (const char* part : {"counts", "error_budget_mm", "page", "ink_left_out_mm"})
    check_no_null(alone[part]);
  const Json bare = report_of("hill.asc");
  CHECK(bare["input"]["scene"].is_null());
  CHECK(bare["counts"]["solids"] == 0);
}

TEST_CASE("what a plane cuts away takes its solids along, and the others stand where they stood") {
  const MadeFolder folder;
  make_inputs(folder);
  // From the south; in front of y = 150 all is cut away.
  folder.write("cutaway.toml", "projection = 'parallel'\nvrp = [200, 200, 100]\nvpn = [0, -1, 0]\n"
                               "vup = [0, 0, 1]\nprp = [0, 150, 100]\n"
                               "window = [-200, -200, 200, 300]\nfront = 50\nback = -1000\n");
  folder.write("two.toml", scene_text("part = 'box'\nat = [200, 200]\n[[place]]\npart = 'box'\n"
                                      "at = [200, 100]"));
  run_line_well(folder, "render hill.asc two.geojson --scene two.toml --view cutaway.toml --report "
                        "two.json --hidden dash");
  run_line_well(folder,
                "render hill.asc one.geojson --scene hut.toml --view cutaway.toml --hidden dash");
  CHECK(Json::parse(folder.read("two.json"))["counts"]["solids"] == 1);
  CHECK(folder.read("two.geojson").find("\"solids\"") != std::string::npos);
  CHECK(Json::parse(folder.read("two.geojson"))["features"] ==
        Json::parse(folder.read("one.geojson"))["features"]);
}

TEST_CASE("an eye between solids, and in one's courtyard, is not inside of any") {
  const MadeFolder folder;
  folder.write("court.toml", "[part.court]\nshape = 'revolution'\nsides = 4\n"
                             "profile = [[30, 0], [40, 0], [40, 20], [30, 20], [30, 0]]\n"
                             "[[place]]\npart = 'court'\nat = [0, 0]\n[[place]]\npart = 'court'\n"
                             "at = [200, 0]\nmap = [{ scale = [-1, 1, 1] }]\n");
  for (const std::string eye : {"0,0,10", "200,0,10", "100,0,10", "0,0,21", "200,34.9,21"})
    run_line_well(folder,
                  "render court.toml out.svg --overwrite --look-azimuth 90 --fov 100 --eye " + eye +
                      (eye == "200,34.9,21" ? " --pitch -30" : ""));
  for (const std::string eye : {"34.9,0,10", "0,34.9,10", "200,34.9,10", "165.1,0,0.001"}) {
    const ProgramRun ended =
        run_line(folder, "render court.toml out.svg --overwrite --look-azimuth 90 --eye " + eye);
    INFO(eye << ": " << ended.err);
    CHECK(ended.exit_code == 1);
    CHECK(ended.err.find("the eye is inside of a solid: court.toml, line ") != std::string::npos);
  }
}
