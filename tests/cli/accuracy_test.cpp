// SPDX-License-Identifier: GPL-3.0-or-later
// `orograph accuracy`: what it writes, and its refusals.
#include "cli/accuracy/accuracy.hpp"
#include "cli/accuracy/accuracy_report.hpp"
#include "cli/options/options.hpp"
#include "dem/read/read_raster.hpp"
#include "geometry/error.hpp"
#include "tests/catch.hpp"
#include "tests/cli/made_files.hpp"
#include "tests/cli/run_program.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <sstream>

using namespace orograph;

namespace {

const std::string kVolcano = OROGRAPH_SOURCE_DIR "/data_samples/volcano.tif";

const std::vector<AccuracyRow>& volcano_rows() {
  static const std::vector<AccuracyRow> rows = [] {
    const AccuracySpec spec{.profiles = {10}, .probes = 200, .repeats = 1};
    const MeasuredTerrain terrain{{kVolcano}, {}, read_rasters({kVolcano}, {})};
    std::vector<AccuracyRow> measured = accuracy_rows(spec, terrain);
    for (AccuracyRow& row : measured) measure_row(row, spec, terrain, {});
    return measured;
  }();
  return rows;
}

std::string accuracy_refusal(const std::vector<std::string>& arguments) {
  try {
    parse_accuracy(arguments);
  } catch (const UsageError& error) {
    return error.what();
  }
  return "accepted";
}

} // namespace

TEST_CASE("a row that breaks its promise fails the run") {
  CHECK_NOTHROW(check_promises(volcano_rows()));
  std::vector<AccuracyRow> rows = volcano_rows();
  AccuracyRow& profiles = rows[1];
  REQUIRE(name_of(profiles) == "profiles, 10 profiles");
  profiles.promise.ink_error = 0; // what the surface promises
  try {
    check_promises(rows);
    FAIL("it was accepted");
  } catch (const Error& error) {
    const std::string message = error.what();
    INFO(message);
    CHECK(message.find("'profiles, 10 profiles'") != std::string::npos);
    CHECK(message.find("ink error") != std::string::npos);
    CHECK(message.find('\n') == std::string::npos);
  }
  profiles.promise = {.ink_error = {}, .displacement_mm = 0.01, .simplified_mm = {}};
  CHECK(broken_promise(profiles).find("displacement") != std::string::npos);
  profiles.promise = {.ink_error = {}, .displacement_mm = {}, .simplified_mm = 0.001};
  CHECK(broken_promise(profiles).find("simplification") != std::string::npos);
  profiles.promise = {
      .ink_error = {}, .displacement_mm = {}, .simplified_mm = {}, .detail_mm = 0.1};
  CHECK(broken_promise(profiles).empty());
  profiles.detail_mm = 0.11;
  CHECK(broken_promise(profiles).find("larger cells") != std::string::npos);
}

TEST_CASE("table, CSV and JSON hold the same rows") {
  const auto& rows = volcano_rows();
  const auto json = nlohmann::json::parse(accuracy_json(rows, "a.tif"));
  CHECK(json["schema"] == 1);
  REQUIRE(json["rows"].size() == rows.size());
  CHECK(json["rows"][0]["occluder"] == "surface");
  CHECK(json["rows"][0]["promised_ink_error"] == 0);
  CHECK(json["rows"][1]["promised_ink_error"].is_null());
  CHECK(json["rows"][0]["total_s"] == rows[0].seconds.total);

  std::istringstream csv(accuracy_csv(rows));
  std::string line;
  std::size_t lines = 0, columns = 0;
  while (std::getline(csv, line)) {
    std::size_t commas = 0;
    bool quoted = false; // names have commas
    for (const char c : line) {
      if (c == '"') quoted = !quoted;
      if (c == ',' && !quoted) ++commas;
    }
    if (lines++ == 0) columns = commas;
    CHECK(commas == columns);
  }
  CHECK(lines == rows.size() + 1);
  CHECK(columns + 1 == json["rows"][0].size());

  const std::string table = accuracy_table(rows);
  CHECK(std::count(table.begin(), table.end(), '\n') ==
        static_cast<std::ptrdiff_t>(rows.size() + 2));
  for (const AccuracyRow& row : rows) CHECK(table.find(name_of(row)) != std::string::npos);
}

TEST_CASE("the program writes all and says so with exit code 0") {
  const MadeFolder folder;
  const std::vector<std::string> command{"accuracy", kVolcano,   "--profiles", "20",
                                         "--probes", "500",      "--repeats",  "1",
                                         "--output", "vol'cano", "--quiet"};
  const ProgramRun run = run_orograph(command, {.folder = folder.path()});
  INFO(run.err);
  REQUIRE(run.exit_code == 0);
  CHECK(run.out.find("surface, 20 profiles") != std::string::npos);
  CHECK(folder.names() ==
        std::vector<std::string>{"vol'cano.csv", "vol'cano.json", "vol'cano.svg"});
  CHECK(nlohmann::json::parse(folder.read("vol'cano.json"))["rows"].size() == 11);
  const std::string svg = folder.read("vol'cano.svg");
  CHECK(svg.find("</svg>") != std::string::npos);
  CHECK(svg.find("volcano.tif") != std::string::npos);

  // A second run refuses to replace them before it measures anything.
  const ProgramRun again = run_orograph(command, {.folder = folder.path()});
  CHECK(again.exit_code == 1);
  CHECK(fault_of_message(again.err).empty());
  CHECK(again.out.empty());
}

TEST_CASE("without gnuplot there is the table alone, and no curve is promised") {
  const MadeFolder folder;
  RunningProgram program({"/usr/bin/env", "PATH=" + folder.path(), OROGRAPH_PROGRAM, "accuracy",
                          kVolcano, "--profiles", "10", "--probes", "200", "--repeats", "1"},
                         {.folder = folder.path()});
  const ProgramRun table = program.wait();
  INFO(table.err);
  CHECK(table.exit_code == 0);
  CHECK(table.out.find("surface, 10 profiles") != std::string::npos);
  RunningProgram plotting({"/usr/bin/env", "PATH=" + folder.path(), OROGRAPH_PROGRAM, "accuracy",
                           kVolcano, "--output", "accuracy"},
                          {.folder = folder.path()});
  const ProgramRun run = plotting.wait();
  INFO(run.err);
  CHECK(run.exit_code == 1);
  CHECK(run.out.empty()); // nothing was measured
  CHECK(run.err.find("gnuplot-nox") != std::string::npos);
  CHECK(fault_of_message(run.err).empty());
  CHECK(folder.names().empty());
}

TEST_CASE("accuracy refuses panoramas, and says what measures them") {
  for (const char* projection : {"cylindrical", "equirectangular"}) {
    const std::string refusal =
        accuracy_refusal({kVolcano, "--projection", projection, "--eye", "2667700,6479200"});
    INFO(projection << ": " << refusal);
    CHECK(refusal.find("a panorama is none") != std::string::npos);
    CHECK(refusal.find("--check") != std::string::npos);
  }
}

TEST_CASE("wrong settings are refused") {
  CHECK(accuracy_refusal({"a.tif"}) == "accepted");
  CHECK(accuracy_refusal({"a.tif", "--profiles", "60,rows", "--view-from", "90/10"}) == "accepted");
  CHECK(accuracy_refusal({"a.tif", "--profiles", "60,,80"}).find("--profiles") !=
        std::string::npos);
  CHECK(accuracy_refusal({"a.tif", "--profiles", "0"}).find("--profiles") != std::string::npos);
  CHECK(accuracy_refusal({"a.tif", "--probes", "10"}).find("--probes") != std::string::npos);
  CHECK(accuracy_refusal({"a.tif", "--overview", "1"}).find("--overview") != std::string::npos);
  CHECK(accuracy_refusal({"a.tif", "--projection", "orthographic", "--fov", "40"}).find("--fov") !=
        std::string::npos);
  CHECK(accuracy_refusal({}).find("INPUT") != std::string::npos);
}
