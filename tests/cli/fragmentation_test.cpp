// SPDX-License-Identifier: GPL-3.0-or-later
// `orograph fragmentation`: what it writes, and its refusals.
#include "cli/fragmentation/fragmentation.hpp"
#include "cli/fragmentation/fragmentation_report.hpp"
#include "cli/options/options.hpp"
#include "geometry/error.hpp"
#include "tests/catch.hpp"
#include "tests/cli/made_files.hpp"
#include "tests/cli/run_program.hpp"
#include "tests/measure/quarry_rows.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <sstream>

using namespace orograph;

namespace {

std::string refusal(const std::vector<std::string>& arguments) {
  try {
    parse_fragmentation(arguments);
  } catch (const UsageError& error) {
    return error.what();
  }
  return "accepted";
}

} // namespace

TEST_CASE("a row that breaks the promise fails the run") {
  CHECK_NOTHROW(check_promises(quarry_rows()));
  std::vector<FragmentationRow> rows = quarry_rows();
  const auto message = [&] {
    try {
      check_promises(rows);
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  rows[2].least->differences.fragments = 3;
  CHECK(message().find("'the surface hides, from 180/25, 15 profiles'") != std::string::npos);
  CHECK(message().find("3 pieces") != std::string::npos);
  CHECK(message().find('\n') == std::string::npos);
  rows[2].least->differences.fragments = 0;
  rows[2].least->differences.wrong = 2;
  CHECK(message().find("in 2 places") != std::string::npos);
}

TEST_CASE("tables, CSV and JSON of a study hold the same rows") {
  const auto& rows = quarry_rows();
  const auto json = nlohmann::json::parse(fragmentation_json(rows, "a.tif"));
  CHECK(json["schema"] == 1);
  REQUIRE(json["rows"].size() == rows.size());
  CHECK(json["rows"][1]["occluder"] == "profiles");
  CHECK(json["rows"][1]["profiles"] == 60);
  CHECK(json["rows"][1]["with_collapse_at_end"] == rows[1].collapsed.at_end);
  CHECK(json["rows"][1]["least_at_end"] == rows[1].least->run.at_end);
  CHECK(json["rows"][1]["has_least_size"] == true);
  REQUIRE(json["growth"].size() == 2);
  CHECK(json["growth"][0]["pieces_without"].get<double>() > 0.9);

  const auto lines_of = [](const std::string& text) {
    return std::count(text.begin(), text.end(), '\n');
  };
  const std::string csv = fragmentation_csv(rows), series = series_csv(rows);
  CHECK(lines_of(csv) == 5);
  CHECK(lines_of(series) == 1 + 2 * (15 + 60));
  CHECK(series.find("\"terrain\",\"profiles\",180,25,60,60," +
                    std::to_string(rows[1].fragmented->at_end) + "," +
                    std::to_string(rows[1].collapsed.at_end)) != std::string::npos);
  std::istringstream table(csv);
  std::string line;
  std::ptrdiff_t commas = -1;
  while (std::getline(table, line)) {
    const auto here = std::count(line.begin(), line.end(), ',');
    CHECK((commas == -1 || here == commas));
    commas = here;
  }
  const std::string text = fragmentation_table(rows);
  for (const FragmentationRow& row : rows) CHECK(text.find(name_of(row)) != std::string::npos);
  CHECK(lines_of(growth_table(rows)) == 3);

  FragmentationRow not_run = rows.front();
  not_run.fragmented.reset();
  not_run.least.reset();
  CHECK(fragmentation_csv({not_run}).find(",,,,") != std::string::npos);
}

TEST_CASE("fragmentation writes all and says so with exit code 0") {
  const MadeFolder folder;
  const std::string hill =
      folder.write("hi'll.asc", ascii_grid(20, 20, [](int c, int r) { return hill_m(c, r, 20); }));
  const std::vector<std::string> command{"fragmentation", hill,           "--profiles", "4,9",
                                         "--elevations",  "3,80",         "--azimuths", "200",
                                         "--worst-case",  "16",           "--output",   "hill",
                                         "--quiet",       "--no-progress"};
  const ProgramRun run = run_orograph(command, {.folder = folder.path()});
  INFO(run.err);
  REQUIRE(run.exit_code == 0);
  CHECK(run.err.empty());
  CHECK(run.out.find("profiles hide, from 200/3, 9 profiles") != std::string::npos);
  CHECK(folder.names() == std::vector<std::string>{"hi'll.asc", "hill-series.csv", "hill.csv",
                                                   "hill.json", "hill.svg"});
  CHECK(nlohmann::json::parse(folder.read("hill.json"))["rows"].size() == 8 + 8);
  const std::string svg = folder.read("hill.svg");
  CHECK(svg.find("</svg>") != std::string::npos);
  CHECK(svg.find("Worst cases") != std::string::npos);

  // One number of profiles alone has no growth, and a plot of points.
  const ProgramRun one =
      run_orograph({"fragmentation", hill, "--profiles", "4", "--worst-case", "0", "--overwrite",
                    "--output", "hill", "--elevations", "20"},
                   {.folder = folder.path()});
  CHECK(one.exit_code == 0);
  CHECK(one.err.empty());
  CHECK(one.out.find("growth") == std::string::npos);

  // Another run refuses to replace them before it measures anything.
  const ProgramRun again = run_orograph(command, {.folder = folder.path()});
  CHECK(again.exit_code == 1);
  CHECK(fault_of_message(again.err).empty());
  CHECK(again.out.empty());
}

TEST_CASE("without gnuplot no plots are promised") {
  const MadeFolder folder;
  const std::string hill =
      folder.write("hill.asc", ascii_grid(9, 9, [](int c, int r) { return hill_m(c, r, 9); }));
  RunningProgram program({"/usr/bin/env", "PATH=" + folder.path(), OROGRAPH_PROGRAM,
                          "fragmentation", hill, "--profiles", "3", "--elevations", "10",
                          "--azimuths", "0", "--worst-case", "0", "--output", "f"},
                         {.folder = folder.path()});
  const ProgramRun run = program.wait();
  INFO(run.err);
  CHECK(run.exit_code == 1);
  CHECK(run.err.find("gnuplot-nox") != std::string::npos);
  CHECK(fault_of_message(run.err).empty());
  CHECK(run.out.empty()); // nothing was measured
  CHECK(folder.names() == std::vector<std::string>{"hill.asc"});
}

TEST_CASE("spec of a study that can't be are refused") {
  CHECK(refusal({"a.tif"}) == "accepted");
  CHECK(refusal({"a.tif", "--profiles", "60,2000", "--azimuths", "-20,0.5"}) == "accepted");
  for (const char* list : {"", ",", "1,", "0", "-3", "1.5", "100001", "60,x"})
    CHECK(refusal({"a.tif", std::string("--profiles=") + list}).find("--profiles") !=
          std::string::npos);
  for (const char* list : {"", "91", "-1", "10;20", "nan"})
    CHECK(refusal({"a.tif", std::string("--elevations=") + list}).find("--elevations") !=
          std::string::npos);
  CHECK(refusal({"a.tif", "--azimuths", "361"}).find("--azimuths") != std::string::npos);
  CHECK(refusal({"a.tif", "--worst-case", "-1"}).find("--worst-case") != std::string::npos);
  CHECK(refusal({"a.csv", "--output", "a"}).find("INPUT") != std::string::npos);
  CHECK(refusal({}).find("INPUT") != std::string::npos);
}
