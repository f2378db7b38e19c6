// SPDX-License-Identifier: GPL-3.0-or-later
// What good command lines give, as a user sees it.
#include "tests/catch.hpp"
#include "tests/cli/made_files.hpp"
#include "tests/cli/run_program.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>

using namespace orograph;

namespace {

constexpr int kHillSide = 40;
double even_hill_m(int column, int row) {
  return hill_m(column, row, kHillSide);
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
    options.insert(options.begin(), {"render", "void.asc", "-", "--of", "svg", "--outline",
                                     "by-layer", // else those that are skyline are there
                                     "--pen-order", "drawing"}); // else it depends on all layers
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

TEST_CASE("render ends with a line, and says when profiles can't show relief") {
  const MadeFolder folder;
  folder.write("hill.asc", ascii_grid(kHillSide, kHillSide, even_hill_m));
  const auto said = [&](std::vector<std::string> options) {
    options.insert(options.begin(), {"render", "hill.asc"});
    options.insert(options.end(), {"--overwrite", "--report", "r.json"});
    const auto result = run_orograph(options, {.folder = folder.path()});
    INFO(result.err);
    REQUIRE(result.exit_code == 0);
    CHECK(result.err.ends_with(" s\n"));
    const std::size_t last = result.err.rfind('\n', result.err.size() - 2);
    const std::string before = last == std::string::npos ? "" : result.err.substr(0, last + 1);
    const std::string line = result.err.substr(before.size());
    const auto report = nlohmann::json::parse(folder.read("r.json"));
    std::string strokes = std::to_string(report["counts"]["strokes"].get<int>());
    if (strokes.size() > 3) strokes.insert(strokes.size() - 3, ",");
    CHECK(holds(line, ": " + strokes + " strokes, "));
    const std::size_t ink = line.find(" strokes, ") + 10;
    CHECK(std::abs(std::stod(line.substr(ink)) - report["pen_down_mm"].get<double>() / 1000) <=
          0.05 + 1e-9);
    return std::pair(before, line);
  };
  const auto plain = said({"a.svg"});
  CHECK(plain.first.empty());
  CHECK(plain.second.starts_with("orograph: a.svg: "));
  CHECK(holds(plain.second, ", from 180/25 in perspective, true heights, "));
  CHECK(holds(said({"-", "--of", "svg"}).second, "orograph: standard output: "));
  CHECK(holds(said({"a.svg", "--exaggeration", "2.5", "--view-from", "10.5/4"}).second,
              ", from 10.5/4 in perspective, heights 2.5 times, "));
  CHECK(holds(said({"a.svg", "--eye", "200,-500,400", "--look-azimuth", "-10"}).second,
              ", from the eye towards azimuth 350, "));
  CHECK(holds(said({"a.svg", "--oblique", "military"}).second, ", from azimuth 180, oblique, "));
  // Low hills are raised, and the line tells the way back.
  folder.write("low.asc", ascii_grid(kHillSide, kHillSide, [](int column, int row) {
                 return 0.01 * even_hill_m(column, row);
               }));
  const auto low = run_orograph({"render", "low.asc", "low.svg"}, {.folder = folder.path()});
  CHECK(holds(low.err, ", heights 2 times (--exaggeration 1 draws them true), "));
  CHECK(said({"a.svg", "--contours", "-9000,200m"}).first.empty());
  for (const std::string levels : {"9000m", "-9000,9000m", "9000ft"})
    CHECK(said({"a.svg", "--contours", levels})
              .first.starts_with("orograph: no contour is drawn: the ground is "));

  const std::string straight = "orograph: from straight above profiles are straight lines";
  const auto plan = [&](const std::string& elevation, std::vector<std::string> options) {
    options.insert(options.begin(), {"a.svg", "--view-from", "20/" + elevation});
    return said(options).first;
  };
  const std::vector<std::string> parallel{"--projection", "orthographic"};
  CHECK(holds(plan("90", parallel), straight + ", and only light on them"));
  CHECK(holds(plan("90", {"--projection", "orthographic", "--light", "off"}),
              straight + ": --light shows relief"));
  CHECK(holds(plan("90", {"--projection", "orthographic", "--of", "geojson"}),
              straight + ": --view-from"));
  CHECK(plan("89", parallel).empty());
  CHECK(plan("90", {}).empty()); // an eye sees them bent
  CHECK(plan("90", {"--oblique", "cabinet"}).empty());
  CHECK(plan("90", {"--projection", "orthographic", "--layers", "border,edges"}).empty());
}

TEST_CASE("a report tells each layer's strokes and ink, before the long list of depths") {
  const MadeFolder folder;
  folder.write("hill.asc", ascii_grid(kHillSide, kHillSide, even_hill_m));
  for (const std::string light : {"picture", "off"}) {
    const auto result = run_orograph({"render", "hill.asc", light + ".svg", "--light", light,
                                      "--view-from", "200/10", "--report", light + ".json"},
                                     {.folder = folder.path()});
    REQUIRE(result.exit_code == 0);
    const std::string text = folder.read(light + ".json");
    CHECK(text.find("\"counts\"") < text.find("\"depths\""));
    CHECK(text.find("\"layers\"") < text.find("\"depths\""));
    const auto report = nlohmann::json::parse(text);
    const std::string svg = folder.read(light + ".svg");
    int strokes = 0;
    double ink_mm = 0, pen_up_mm = 0;
    for (const auto& layer : report["layers"]) {
      const std::size_t label = svg.find(" " + layer["name"].get<std::string>() + "\"");
      INFO(light << " " << layer);
      REQUIRE(label != std::string::npos);
      const std::size_t begin = svg.find('\n', label);
      const std::string group = svg.substr(begin, svg.find("</g>", begin) - begin);
      CHECK(std::count(group.begin(), group.end(), 'M') == layer["strokes"].get<int>());
      strokes += layer["strokes"].get<int>();
      ink_mm += layer["ink_mm"].get<double>();
      pen_up_mm += layer["pen_up_mm"].get<double>();
    }
    CHECK(strokes == report["counts"]["strokes"].get<int>());
    // But for the order of sums.
    CHECK(std::abs(ink_mm - report["pen_down_mm"].get<double>()) <= 1e-9 * ink_mm);
    CHECK(std::abs(pen_up_mm - report["pen_up_mm"].get<double>()) <= 1e-9 * pen_up_mm);
  }
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
