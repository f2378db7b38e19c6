// SPDX-License-Identifier: GPL-3.0-or-later
// Pens and sheets as the command draws them: whole files, the same on any number of threads.
#include "tests/catch.hpp"
#include "tests/cli/made_files.hpp"
#include "tests/cli/run_program.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace orograph::plotting_test {
namespace {

using Words = std::vector<std::string>;

constexpr const char* kPens = "[[pen]]\nnumber = 2\nname = 'fine'\nwidth = 0.1\nspeed = 40\n"
                              "layers = ['profiles']\n"
                              "[[pen]]\nnumber = 4\nname = 'broad'\nwidth = 0.3\nspeed = 20\n";

ProgramRun render(const MadeFolder& folder, const std::string& output, Words more,
                  const RunConditions& conditions = {}) {
  RunConditions there = conditions;
  there.folder = folder.path();
  more.insert(more.begin(), {"render", "hill.asc", output});
  return run_orograph(more, there);
}

void write_files(const MadeFolder& folder) {
  folder.write("hill.asc", ascii_grid(60, 60, [](int column, int row) {
                 return hill_m(column, row, 60) + 20 * std::sin(0.5 * column);
               }));
  folder.write("pens.toml", kPens);
}

} // namespace

TEST_CASE("HPGL by several pens is the same on any number of threads, with minutes for each") {
  const MadeFolder folder;
  write_files(folder);
  const Words pens{"--pens", "pens.toml", "--pen-lift-s", "1", "--jobs"};
  const auto with_jobs = [&](const char* jobs, Words more) {
    Words words = pens;
    words.push_back(jobs);
    words.insert(words.end(), more.begin(), more.end());
    return words;
  };
  const ProgramRun one = render(folder, "one.hpgl", with_jobs("1", {"--report", "one.json"}));
  INFO(one.err);
  REQUIRE(one.exit_code == 0);
  REQUIRE(render(folder, "many.hpgl", with_jobs("4", {})).exit_code == 0);
  CHECK((folder.read("one.hpgl") == folder.read("many.hpgl")));
  CHECK(folder.read("one.hpgl").find("SP2;") != std::string::npos);
  CHECK(folder.read("one.hpgl").find("SP4;") != std::string::npos);
  const auto report = nlohmann::json::parse(folder.read("one.json"));
  REQUIRE(report["layers"].size() == 2);
  double sum = 0;
  std::size_t strokes = 0;
  for (const auto& layer : report["layers"]) {
    const double mm_s = layer["name"] == "fine" ? 40 : 20;
    const double minutes =
        ((layer["ink_mm"].get<double>() + layer["pen_up_mm"].get<double>()) / mm_s +
         layer["pen_lifts"].get<double>()) /
        60;
    CHECK(std::abs(layer["pen_minutes"].get<double>() - minutes) < 1e-9);
    sum += minutes;
    strokes += layer["strokes"].get<std::size_t>();
  }
  CHECK(std::abs(report["pen_minutes"].get<double>() - sum) < 1e-9);
  CHECK(report["counts"]["strokes"] == strokes);
  CHECK(one.err.find(" " + std::to_string(static_cast<int>(std::ceil(sum))) +
                     " minutes for the pen") != std::string::npos);
}

TEST_CASE("sheets are written all or none") {
  const MadeFolder folder;
  write_files(folder);
  const Words sheets{"--sheets", "2x1", "--page", "a5", "--overlap", "10mm"};
  const auto before = folder.names();
  // The second sheet is the larger one, or the first: one of them doesn't fit.
  CHECK(render(folder, "map.svg", sheets, {.folder = {}, .largest_file_bytes = 40'000}).exit_code ==
        1);
  CHECK(folder.names() == before);
  const ProgramRun run = render(folder, "map.svg", sheets);
  INFO(run.err);
  REQUIRE(run.exit_code == 0);
  CHECK(run.err.find("map-1.svg to map-2.svg") != std::string::npos);
  for (const char* name : {"map-1.svg", "map-2.svg", "map-overview.svg"})
    CHECK(folder.read(name).ends_with("</svg>\n"));
  CHECK(folder.names().size() == before.size() + 3);
  CHECK(folder.read("map-1.svg").find("register") != std::string::npos);
  const std::string first = folder.read("map-1.svg");
  CHECK(render(folder, "map.svg", sheets).exit_code == 1); // they are there
  CHECK((folder.read("map-1.svg") == first));
}

TEST_CASE("a report tells what each sheet takes, and all together") {
  const MadeFolder folder;
  write_files(folder);
  for (const std::string pens : {"", "pens.toml"}) {
    Words words{"--sheets", "2x2",         "--page",       "a6", "--pen-speed", "20", "--report",
                "r.json",   "--overwrite", "--pen-lift-s", "1"};
    if (!pens.empty()) words.insert(words.end(), {"--pens", pens});
    const ProgramRun run = render(folder, "map.svg", words);
    INFO(run.err);
    REQUIRE(run.exit_code == 0);
    const auto report = nlohmann::json::parse(folder.read("r.json"));
    REQUIRE(report["sheets"].size() == 4);
    double ink_mm = 0, up_mm = 0, minutes = 0;
    std::size_t strokes = 0, in_layers = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      const auto& sheet = report["sheets"][i];
      const std::string name = "map-" + std::to_string(i + 1) + ".svg";
      CHECK(sheet["path"] == name);
      // What is in the file, by its text.
      const std::string svg = folder.read(name);
      std::size_t paths = 0;
      for (std::size_t at = 0; (at = svg.find("<path", at)) != std::string::npos; ++at) ++paths;
      CHECK(sheet["strokes"] == paths);
      strokes += paths;
      ink_mm += sheet["ink_mm"].get<double>();
      up_mm += sheet["pen_up_mm"].get<double>();
      minutes += sheet["pen_minutes"].get<double>();
    }
    for (const auto& layer : report["layers"]) in_layers += layer["strokes"].get<std::size_t>();
    CHECK(report["counts"]["strokes"] == strokes);
    CHECK(in_layers == strokes);
    CHECK(std::abs(report["pen_down_mm"].get<double>() - ink_mm) < 1e-6);
    CHECK(std::abs(report["pen_up_mm"].get<double>() - up_mm) < 1e-6);
    CHECK(std::abs(report["pen_minutes"].get<double>() - minutes) < 1e-9);
    CHECK(run.err.find(" " + std::to_string(static_cast<int>(std::ceil(minutes))) +
                       " minutes for the pen") != std::string::npos);
  }
  REQUIRE(render(folder, "one.svg", {"--report", "one.json"}).exit_code == 0);
  CHECK(nlohmann::json::parse(folder.read("one.json"))["sheets"].is_null());
}

} // namespace orograph::plotting_test
