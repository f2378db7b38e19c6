// SPDX-License-Identifier: GPL-3.0-or-later
// What good command lines give, as a user sees it.
#include "tests/catch.hpp"
#include "tests/cli/made_files.hpp"
#include "tests/cli/run_program.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>

using namespace orograph;

namespace {

constexpr int kSize = 40;
double small_hill_m(int column, int row) {
  return hill_m(column, row, kSize);
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
  folder.write("hill.asc", ascii_grid(kSize, kSize, small_hill_m));
  const auto text = run_orograph({"info", "hill.asc"}, {.folder = folder.path()});
  INFO(text.err);
  CHECK(text.exit_code == 0);
  CHECK(holds(text.out, "40 x 40 vertices"));
  CHECK(holds(text.out, "5,5,395,395"));

  folder.write("hill.tif", geotiff(kSize, kSize, small_hill_m));
  const auto window =
      run_orograph({"info", "hill.tif", "--bbox", "100,100,200,300"}, {.folder = folder.path()});
  INFO(window.err);
  CHECK(window.exit_code == 0);
  CHECK(holds(window.out, "10 x 20 vertices"));
  CHECK(holds(window.out, "105,105,195,295"));
}

TEST_CASE("render writes every format and a report, the same bytes each time") {
  const MadeFolder folder;
  folder.write("hill.asc", ascii_grid(kSize, kSize, small_hill_m));
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

TEST_CASE("OUTPUT - is standard output, alone") {
  const MadeFolder folder;
  folder.write("hill.asc", ascii_grid(kSize, kSize, small_hill_m));
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
  folder.write("hill.asc", ascii_grid(kSize, kSize, small_hill_m));
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
  folder.write("hill.asc", ascii_grid(kSize, kSize, small_hill_m));
  folder.write("map.svg", "an older drawing");
  const auto result = run_orograph({"render", "hill.asc", "map.svg", "--overwrite", "--eye",
                                    "-300,200,350", "--look-at", "200,200,150", "--roll", "-5"},
                                   {.folder = folder.path()});
  INFO(result.err);
  CHECK(result.exit_code == 0);
  CHECK(folder.read("map.svg").ends_with("</svg>\n"));
  CHECK(folder.names() == std::vector<std::string>{"hill.asc", "map.svg"});
}
