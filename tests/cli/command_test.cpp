// SPDX-License-Identifier: GPL-3.0-or-later
// What good command lines give, as a user sees it.
#include "tests/catch.hpp"
#include "tests/cli/made_files.hpp"
#include "tests/cli/run_program.hpp"

#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>

using namespace orograph;

namespace {

constexpr int kHillSide = 40;
double even_hill_m(int column, int row) {
  return hill_m(column, row, kHillSide);
}

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

} // namespace

TEST_CASE("help and version go to standard output") {
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"--help"}, {"-h"}, {"render", "--help"}, {"info", "-h"}}) {
    const auto result = run_orograph(arguments, {});
    CHECK(result.exit_code == 0);
    CHECK(holds(result.out, "Usage: orograph"));
    CHECK(result.err == "");
  }
  const auto version = run_orograph({"--version"}, {});
  CHECK(version.exit_code == 0);
  CHECK(version.out.starts_with("orograph "));
  CHECK(holds(version.out, "(commit "));
  CHECK(run_orograph({"--man"}, {}).out.starts_with(".TH OROGRAPH 1"));
}

TEST_CASE("info tells what a file holds") {
  const MadeFolder folder;
  folder.write("hill.asc", ascii_grid(kHillSide, kHillSide, even_hill_m));
  const auto text = run_orograph({"info", "hill.asc"}, {.folder = folder.path()});
  INFO(text.err);
  CHECK(text.exit_code == 0);
  CHECK(holds(text.out, "40 x 40 vertices"));
  CHECK(holds(text.out, "5,5,395,395"));

  folder.write("hill.tif", geotiff(kHillSide, kHillSide, even_hill_m));
  const auto window =
      run_orograph({"info", "hill.tif", "--bbox", "100,100,200,300"}, {.folder = folder.path()});
  INFO(window.err);
  CHECK(window.exit_code == 0);
  CHECK(holds(window.out, "10 x 20 vertices"));
  CHECK(holds(window.out, "105,105,195,295"));
}

TEST_CASE("an eye by longitude and latitude is where the report says, and looks where it is told") {
  const MadeFolder folder;
  folder.write("hill.asc", ascii_grid(kHillSide, kHillSide, even_hill_m));
  folder.write("hill.prj", kUtm32);
  const auto view_of = [&](std::vector<std::string> options) {
    options.insert(options.begin(), {"render", "hill.asc", "a.svg"});
    options.insert(options.end(), {"--report", "a.json", "--overwrite"});
    const auto result = run_orograph(options, {.folder = folder.path()});
    INFO(result.err);
    REQUIRE(result.exit_code == 0);
    return nlohmann::json::parse(folder.read("a.json"))["view"];
  };
  // But for the rounding of places in degrees.
  const auto near = [](const nlohmann::json& one, const nlohmann::json& other) {
    REQUIRE(one.size() == other.size());
    for (std::size_t i = 0; i < one.size(); ++i)
      CHECK(std::abs(one[i].get<double>() - other[i].get<double>()) <= 1e-6);
  };
  const auto text = [](const nlohmann::json& lonlat) {
    return lonlat[0].dump() + "," + lonlat[1].dump();
  };
  const auto by_map = view_of({"--eye", "100,60", "--look-at", "205,200", "--exaggeration", "3"});
  CHECK(std::abs(by_map["eye_height_m"].get<double>() - 2) <= 1e-9);
  CHECK(std::abs(by_map["eye_lonlat"][0].get<double>() - 4.512) < 0.001);
  CHECK(by_map["eye_lonlat"][2] == by_map["eye"][2]);
  const auto by_lonlat = view_of({"--eye-lonlat", text(by_map["eye_lonlat"]), "--look-at-lonlat",
                                  text(by_map["look_at_lonlat"]), "--exaggeration", "3"});
  near(by_lonlat["eye"], by_map["eye"]);
  near(by_lonlat["look_at"], by_map["look_at"]);
  near(by_lonlat["forward"], by_map["forward"]);

  const auto direction =
      view_of({"--eye", "100,60", "--look-azimuth", "40", "--pitch", "5", "--eye-height", "30"});
  CHECK(std::abs(direction["look_azimuth_true_deg"].get<double>() - 40) <= 1e-7);
  // Near the equator north is nearly the map's.
  CHECK(std::abs(direction["look_azimuth_deg"].get<double>() - 40) < 0.01);
  CHECK(direction["look_azimuth_deg"] != direction["look_azimuth_true_deg"]);
  CHECK(direction["elevation_deg"] == -5);
  CHECK(std::abs(direction["eye_height_m"].get<double>() - 30) <= 1e-9);
  CHECK(direction["look_at"].is_null());
  CHECK(direction["look_at_lonlat"].is_null());
  CHECK(direction["distance_m"].is_null());
  CHECK(direction["exaggeration"] == 1);

  const auto outside = view_of({"--eye", "200,-500,500"});
  CHECK(outside["eye_height_m"].is_null());
  const auto parallel =
      view_of({"--projection", "orthographic", "--look-at-lonlat", text(by_map["look_at_lonlat"])});
  CHECK(parallel["eye_lonlat"].is_null());
  CHECK(parallel["eye_height_m"].is_null());
  near({parallel["look_at_lonlat"][0], parallel["look_at_lonlat"][1]},
       {by_map["look_at_lonlat"][0], by_map["look_at_lonlat"][1]});

  folder.write("plain.asc", ascii_grid(kHillSide, kHillSide, even_hill_m));
  REQUIRE(run_orograph({"render", "plain.asc", "b.svg", "--eye", "100,60", "--report", "b.json"},
                       {.folder = folder.path()})
              .exit_code == 0);
  const auto plain = nlohmann::json::parse(folder.read("b.json"));
  CHECK(plain["view"]["eye_lonlat"].is_null());
  CHECK(plain["view"]["look_azimuth_true_deg"].is_null());
  CHECK(plain["input"]["vertical_crs"].is_null());
}

TEST_CASE("render writes every format and a report, the same bytes each time") {
  const MadeFolder folder;
  folder.write("hill.asc", ascii_grid(kHillSide, kHillSide, even_hill_m));
  for (const std::string extension : {"svg", "pdf", "ps", "eps", "png", "geojson", "gpkg"}) {
    const std::string first = "first." + extension, again = "again." + extension;
    const auto result = run_orograph(
        {"render", "hill.asc", first, "--title", "Hill", "--report", extension + ".json"},
        {.folder = folder.path()});
    INFO(extension << ": " << result.err);
    REQUIRE(result.exit_code == 0);
    CHECK(result.out == "");
    const auto report = nlohmann::json::parse(folder.read(extension + ".json"));
    CHECK(report["schema"] == 1);
    CHECK(report["output"]["format"] == extension);
    CHECK(report["profiles"]["count"] == report["profiles"]["depths"].size());
    CHECK(report["counts"]["strokes"] > 0);
    CHECK(report["error_budget_mm"]["total"].is_number());
    CHECK(run_orograph({"render", "hill.asc", again, "--title", "Hill"}, {.folder = folder.path()})
              .exit_code == 0);
    CHECK(folder.read(first).size() > 100);
    CHECK(folder.read(first) == folder.read(again));
  }
}

TEST_CASE("voids are gaps, outlined if asked for") {
  const MadeFolder folder;
  folder.write("void.asc", ascii_grid(kHillSide, kHillSide, [](int column, int row) {
                 const bool in_void = column > 14 && column < 25 && row > 14 && row < 25;
                 return in_void ? -9999 : even_hill_m(column, row);
               }));
  const auto drawn = [&](std::vector<std::string> options) {
    options.insert(options.begin(), {"render", "void.asc", "-", "--of", "svg"});
    const auto result = run_orograph(options, {.folder = folder.path()});
    INFO(result.err);
    CHECK(result.exit_code == 0);
    return result.out;
  };
  const auto layer = [](const std::string& svg, const std::string& name) {
    const std::size_t label = svg.find(" " + name + "\"");
    if (label == std::string::npos) return std::string();
    const std::size_t begin = svg.find('\n', label);
    return svg.substr(begin, svg.find("</g>", begin) - begin);
  };
  const std::string plain = drawn({}), outlined = drawn({"--void-edges"}),
                    alone = drawn({"--layers", "voids"});
  CHECK(layer(plain, "voids").empty());
  CHECK(holds(layer(outlined, "voids"), "<path"));
  for (const char* name : {"profiles", "border", "silhouettes", "skyline"}) {
    CHECK(holds(layer(plain, name), "<path"));
    CHECK(layer(plain, name) == layer(outlined, name));
  }
  CHECK(layer(alone, "voids") == layer(outlined, "voids"));
  CHECK(layer(alone, "profiles").empty());
  CHECK(drawn({"--layers", "profiles", "--void-edges"}) == drawn({"--layers", "profiles,voids"}));
  CHECK(layer(drawn({"--fill-voids", "20", "--void-edges"}), "voids") == "\n");
}

TEST_CASE("OUTPUT - is standard output, alone") {
  const MadeFolder folder;
  folder.write("hill.asc", ascii_grid(kHillSide, kHillSide, even_hill_m));
  const auto before = folder.names();
  const auto result =
      run_orograph({"render", "hill.asc", "-", "--of", "svg"}, {.folder = folder.path()});
  INFO(result.err);
  CHECK(result.exit_code == 0);
  CHECK(result.out.starts_with("<?xml"));
  CHECK(result.out.ends_with("</svg>\n"));
  CHECK(folder.names() == before);
}

TEST_CASE("quiet says nothing; progress shows a bar where it is asked for") {
  const MadeFolder folder;
  folder.write("hill.asc", ascii_grid(kHillSide, kHillSide, even_hill_m));
  const auto quiet = run_orograph({"render", "hill.asc", "a.svg", "-q"}, {.folder = folder.path()});
  CHECK(quiet.exit_code == 0);
  CHECK(quiet.err == "");
  const auto shown =
      run_orograph({"render", "hill.asc", "b.svg", "--progress"}, {.folder = folder.path()});
  CHECK(shown.exit_code == 0);
  CHECK(holds(shown.err, "0...10...20...30...40...50...60...70...80...90...100 - done.\n"));
  const auto unasked = run_orograph({"render", "hill.asc", "c.svg"}, {.folder = folder.path()});
  CHECK_FALSE(holds(unasked.err, "...10"));
}

TEST_CASE("--overwrite replaces, and a negative first value is one") {
  const MadeFolder folder;
  folder.write("hill.asc", ascii_grid(kHillSide, kHillSide, even_hill_m));
  folder.write("map.svg", "an older drawing");
  const auto result = run_orograph({"render", "hill.asc", "map.svg", "--overwrite", "--eye",
                                    "-300,200,350", "--look-at", "200,200,150", "--roll", "-5"},
                                   {.folder = folder.path()});
  INFO(result.err);
  CHECK(result.exit_code == 0);
  CHECK(folder.read("map.svg").ends_with("</svg>\n"));
  CHECK(folder.names() == std::vector<std::string>{"hill.asc", "map.svg"});
}
