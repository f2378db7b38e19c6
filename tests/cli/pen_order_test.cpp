// SPDX-License-Identifier: GPL-3.0-or-later
// The order of strokes on real drawings: every sample, all layers, whatever shows light. And which
// order the command writes.
#include "dem/read/read_terrain.hpp"
#include "draw/pen_order.hpp"
#include "map/draw_map.hpp"
#include "placing/placed_view.hpp"
#include "placing/terrain_of_view.hpp"
#include "solids/read_scene.hpp"
#include "tests/catch.hpp"
#include "tests/cli/made_files.hpp"
#include "tests/cli/run_program.hpp"
#include "tests/support/ink.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

namespace orograph::pen_order_test {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

const fs::path kSamples = fs::path(OROGRAPH_SOURCE_DIR) / "data_samples";

enum class Light { off, by_width, by_density };

MapSpec spec_with(Light light) {
  MapSpec spec;
  if (light == Light::off)
    spec.style.light.reset();
  else
    spec.style.light->by_density = light == Light::by_density;
  return spec;
}

Drawing drawn(const TerrainData& terrain, const MapSpec& spec, const SceneFile* solids = nullptr) {
  const TerrainOfView of_view(terrain, spec.view);
  return draw_map(*of_view, placed_view(of_view, spec, solids), spec, [](double) {}).drawing;
}

// The pen's way through the air over its ink, added up here.
double up_over_ink(const Drawing& drawing) {
  double up = 0, ink = 0;
  Vec2 pen{0, 0};
  for (const Layer& layer : drawing.layers)
    for (const Stroke& stroke : layer.strokes) {
      const auto points = layer.points(stroke);
      up += length(points[0] - pen);
      for (std::size_t i = 1; i < points.size(); ++i) ink += length(points[i] - points[i - 1]);
      pen = points.back();
    }
  return up / ink;
}

void check_ink(const Drawing& drawing) {
  for (const PenOrder order : {PenOrder::sorted, PenOrder::best}) {
    Drawing ordered = drawing;
    order_for_pen(ordered, order);
    REQUIRE(ordered.layers.size() == drawing.layers.size());
    for (std::size_t i = 0; i < drawing.layers.size(); ++i) {
      INFO(drawing.layers[i].name);
      CHECK((ink_of(ordered.layers[i]) == ink_of(drawing.layers[i])));
    }
    CHECK(find_fault(ordered) == std::nullopt);
  }
}

} // namespace

TEST_CASE("order changes no ink of any sample") {
  std::vector<std::string> names;
  for (const auto& file : fs::directory_iterator(kSamples))
    if (file.path().extension() == ".tif") names.push_back(file.path().string());
  std::sort(names.begin(), names.end());
  REQUIRE(names.size() >= 9);
  std::vector<TerrainData> terrains;
  for (const std::string& name : names) terrains.push_back(read_terrain({name}, {}));
  ReadOptions with_breaklines;
  with_breaklines.breaklines = (kSamples / "quarry_breaklines.geojson").string();
  names.emplace_back("quarry");
  terrains.push_back(read_terrain({(kSamples / "quarry_points.csv").string()}, with_breaklines));
  for (std::size_t i = 0; i < terrains.size(); ++i)
    for (const Light light : {Light::off, Light::by_width, Light::by_density}) {
      if (light != Light::by_width && i % 3 != 0) continue; // widths end strokes
      INFO(names[i]);
      MapSpec spec = spec_with(light);
      spec.style.layers = {"profiles", "edges", "waterlines",  "shores",
                           "border",   "voids", "silhouettes", "skyline"};
      check_ink(drawn(terrains[i], spec));
    }
  const SceneFile village = read_scene((kSamples / "scenes" / "village.toml").string());
  MapSpec spec;
  spec.style.layers.emplace_back("hidden");
  const auto volcano = std::ranges::find(names, (kSamples / "volcano.tif").string());
  check_ink(drawn(terrains[static_cast<std::size_t>(volcano - names.begin())], spec, &village));
}

TEST_CASE("the pen's way through the air is a fourth of the ink, or a fifth") {
  for (const char* name : {"fractal_alps.tif", "jacksboro.tif", "volcano.tif"})
    for (const Light light : {Light::off, Light::by_width, Light::by_density}) {
      INFO(name);
      Drawing sorted = drawn(read_terrain({(kSamples / name).string()}, {}), spec_with(light));
      Drawing best = sorted;
      CHECK(up_over_ink(sorted) > 1.2);
      order_for_pen(sorted, PenOrder::sorted);
      order_for_pen(best, PenOrder::best);
      CHECK(up_over_ink(sorted) <= 0.25);
      CHECK(up_over_ink(best) <= 0.2);
      CHECK(up_over_ink(best) < up_over_ink(sorted));
    }
}

namespace {

std::string write_hills(const MadeFolder& folder) {
  return folder.write("hills.asc", ascii_grid(60, 60, [](int column, int row) {
                        return 200 + 60 * std::sin(0.3 * column) * std::cos(0.25 * row);
                      }));
}

std::string render(const MadeFolder& folder, const std::string& output, const Words& options) {
  Words words{"render", "hills.asc", output, "--overwrite", "--quiet"};
  if (output.ends_with(".png")) words.insert(words.end(), {"--dpi", "40"});
  words.insert(words.end(), options.begin(), options.end());
  const ProgramRun run = run_orograph(words, {.folder = folder.path()});
  INFO(run.err);
  REQUIRE(run.exit_code == 0);
  return folder.read(output);
}

} // namespace

TEST_CASE("formats that a pen may draw are sorted, others as they are drawn, unless told") {
  const MadeFolder folder;
  write_hills(folder);
  for (const std::string format : {"svg", "ps", "eps", "pdf", "png"}) {
    INFO(format);
    const std::string output = "out." + format;
    const std::string by_default = render(folder, output, {}),
                      drawing = render(folder, output, {"--pen-order", "drawing"}),
                      sorted = render(folder, output, {"--pen-order", "sorted"}),
                      best = render(folder, output, {"--pen-order", "best"});
    const bool is_for_pen = format != "pdf" && format != "png";
    CHECK((by_default == (is_for_pen ? sorted : drawing)));
    if (format == "png") continue; // where lines cross, the order of rounding may be seen, or not
    CHECK((drawing != sorted));
    CHECK((sorted != best));
  }
  const std::string by_default = render(folder, "out.geojson", {});
  CHECK((render(folder, "out.geojson", {"--pen-order", "drawing"}) == by_default));
}

TEST_CASE("the best order is the same on one core and on two") {
  const MadeFolder folder;
  write_hills(folder);
  const Words best{"--pen-order", "best", "--jobs"};
  const auto with_jobs = [&](const char* jobs) {
    return render(folder, "out.svg", {best[0], best[1], best[2], jobs});
  };
  CHECK((with_jobs("1") == with_jobs("2")));
}

TEST_CASE("a report tells the pen's way as it is written") {
  const MadeFolder folder;
  write_hills(folder);
  for (const std::string order : {"drawing", "sorted", "best"}) {
    INFO(order);
    const std::string svg =
        render(folder, "out.svg", {"--pen-order", order, "--report", "out.json"});
    const auto report = nlohmann::json::parse(folder.read("out.json"));
    // From the text alone: a layer begins with <g, a stroke with <path d="M.
    std::vector<double> up_mm;
    std::vector<std::size_t> strokes;
    Vec2 pen{0, 0};
    std::istringstream lines(svg);
    for (std::string line; std::getline(lines, line);) {
      if (line.starts_with("<g ")) {
        up_mm.push_back(0);
        strokes.push_back(0);
      }
      constexpr std::string_view kPath = "<path d=\"M";
      if (!line.starts_with(kPath)) continue;
      std::string points = line.substr(kPath.size(), line.find('"', kPath.size()) - kPath.size());
      std::ranges::replace_if(
          points, [](char c) { return c == ',' || c == 'L'; }, ' ');
      std::istringstream numbers(points);
      Vec2 p;
      bool is_first = true;
      while (numbers >> p.x >> p.y) {
        if (is_first) up_mm.back() += length(p - pen);
        is_first = false;
        pen = p;
      }
      ++strokes.back();
    }
    REQUIRE(report["layers"].size() == up_mm.size());
    for (std::size_t i = 0; i < up_mm.size(); ++i) {
      CHECK(std::abs(report["layers"][i]["pen_up_mm"].get<double>() - up_mm[i]) < 1e-6);
      CHECK(report["layers"][i]["strokes"].get<std::size_t>() == strokes[i]);
    }
  }
}

TEST_CASE("minutes are told for a pen's speed, in the report and on the closing line") {
  const MadeFolder folder;
  write_hills(folder);
  const auto run = run_orograph({"render", "hills.asc", "out.svg", "--report", "out.json",
                                 "--pen-speed", "20", "--pen-up-speed", "50", "--pen-lift-s", "2"},
                                {.folder = folder.path()});
  REQUIRE(run.exit_code == 0);
  const auto report = nlohmann::json::parse(folder.read("out.json"));
  double sum = 0;
  for (const auto& layer : report["layers"]) {
    const double minutes =
        (layer["ink_mm"].get<double>() / 20 + layer["pen_up_mm"].get<double>() / 50 +
         2 * layer["pen_lifts"].get<double>()) /
        60;
    CHECK(std::abs(layer["pen_minutes"].get<double>() - minutes) < 1e-9);
    sum += minutes;
  }
  CHECK(std::abs(report["pen_minutes"].get<double>() - sum) < 1e-9);
  CHECK(sum > 1);
  const std::string told =
      " " + std::to_string(static_cast<int>(std::ceil(sum))) + " minutes for the pen";
  INFO(run.err);
  CHECK(run.err.find(told) != std::string::npos);
  render(folder, "out.svg", {"--report", "out.json"});
  CHECK(nlohmann::json::parse(folder.read("out.json"))["pen_minutes"].is_null());
}

TEST_CASE("the pen's way is a layer that no plotter draws, and changes nothing else") {
  const MadeFolder folder;
  write_hills(folder);
  const Words plain{"--layers", "profiles,skyline", "--report", "plain.json"};
  const std::string without = render(folder, "out.svg", plain),
                    with = render(folder, "out.svg",
                                  {"--layers", "profiles,skyline,pen-up", "--report", "way.json"});
  const std::size_t begin = with.find("<g id=\"layer3\"");
  REQUIRE(begin != std::string::npos);
  CHECK(with.find("inkscape:label=\"%3 pen-up\"") != std::string::npos);
  CHECK((with.substr(0, begin) + "</svg>\n" == without));
  const auto report = nlohmann::json::parse(folder.read("plain.json")),
             shown = nlohmann::json::parse(folder.read("way.json"));
  for (const char* key : {"pen_up_mm", "pen_down_mm", "pen_lifts"})
    CHECK(shown[key] == report[key]);
  // It is the way in the order in which strokes are written, move for move as long.
  double shown_mm = 0;
  for (std::size_t at = begin; (at = with.find("<path d=\"", at)) != std::string::npos; ++at) {
    Vec2 from, to;
    REQUIRE(std::sscanf(with.c_str() + at, "<path d=\"M%lf,%lfL%lf,%lf\"", &from.x, &from.y, &to.x,
                        &to.y) == 4);
    shown_mm += length(to - from);
  }
  CHECK(std::abs(shown_mm - report["pen_up_mm"].get<double>()) < 1e-6);
  CHECK(shown["counts"]["strokes"] == report["counts"]["strokes"]);
  CHECK(shown["layers"][2]["strokes"] == report["pen_lifts"]);
}

} // namespace orograph::pen_order_test
