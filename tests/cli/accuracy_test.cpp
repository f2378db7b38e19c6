// SPDX-License-Identifier: GPL-3.0-or-later
// `orograph accuracy`: its measures on a small terrain, what it writes, and its refusals.
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
#include <cmath>
#include <sstream>

using namespace orograph;

namespace {

const std::string kVolcano = OROGRAPH_SOURCE_DIR "/data_samples/volcano.tif";

AccuracySettings small_settings() {
  AccuracySettings settings;
  settings.render.inputs = {kVolcano};
  settings.profiles = {25};
  settings.probes = 2000;
  settings.repeats = 1;
  return settings;
}

std::vector<AccuracyRow> measured(const AccuracySettings& settings) {
  const TerrainData terrain = read_rasters(settings.render.inputs, settings.render.reading);
  std::vector<AccuracyRow> rows = accuracy_rows(settings);
  for (AccuracyRow& row : rows) measure_row(row, settings, terrain);
  return rows;
}

const std::vector<AccuracyRow>& volcano_rows() {
  static const std::vector<AccuracyRow> rows = measured(small_settings());
  return rows;
}

const AccuracyRow& row_named(const std::string& name) {
  const auto& rows = volcano_rows();
  const auto row = std::find_if(rows.begin(), rows.end(),
                                [&](const AccuracyRow& r) { return name_of(r) == name; });
  INFO(name);
  REQUIRE(row != rows.end());
  return *row;
}

double ink_error(const AccuracyRow& row) {
  return (row.profiles + row.lines).error();
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

TEST_CASE("what the surface hides is drawn without error, what profiles hide is not") {
  for (const AccuracyRow& row : volcano_rows()) {
    INFO(name_of(row));
    CHECK(row.profiles.asked >= 1900); // 2000 but for what begins and ends between two of them
    CHECK(row.seconds.total > 0);
    if (row.settings.occluder == Occluder::surface) {
      CHECK(ink_error(row) == 0);
      CHECK(row.lines.asked > 100);
      CHECK(row.ends.asked > 10);
      CHECK(row.ends.astray == 0);
      CHECK(row.ends.largest_mm <= 1e-4); // the visibility tolerance
    } else {
      // With a profile to each 3 rows, the crater's rim stands between two of them.
      CHECK(row.profiles.error() > 0.02);
      CHECK(row.ends.largest_mm > 0.05);
      CHECK(row.profiles.standard_error() > 0);
      CHECK(row.profiles.standard_error() < row.profiles.error());
    }
    CHECK(broken_promise(row).empty());
  }
}

TEST_CASE("simplification is measured, and stays within its promise") {
  CHECK(row_named("surface, 25 profiles, simplify 0 mm").simplified->largest_mm == 0);
  const AccuracyRow& row = row_named("surface, 25 profiles, simplify 0.1 mm");
  CHECK(row.simplified->largest_mm > 0.03);
  CHECK(row.simplified->largest_mm <= 0.1 + 1e-4);
  CHECK(row.simplified->unmatched == 0);
  CHECK(row.simplified->strokes == row.counts.strokes);
  REQUIRE(row.promise.displacement_mm);
  // 0.1 of simplification, 1e-4 of tolerance, half the diagonal of a step of 1e-4.
  CHECK(std::abs(*row.promise.displacement_mm - (0.1 + 1e-4 + 0.7072e-4)) < 1e-7);
}

TEST_CASE("arithmetic is measured against exact arithmetic") {
  CHECK_FALSE(row_named("profiles, 25 profiles, exact").arithmetic_mm);
  // Ends of the clip in double are within 1e-9 mm (docs/how-it-works.md), and float isn't that
  // good.
  CHECK(*row_named("profiles, 25 profiles, double").arithmetic_mm <= 1e-9);
  const double in_float = *row_named("profiles, 25 profiles, float").arithmetic_mm;
  CHECK(in_float > 1e-7);
  CHECK(in_float < 0.01);
}

TEST_CASE("without collapse the horizon grows, and hides the same") {
  const AccuracyRow& with = row_named("profiles, 25 profiles");
  const AccuracyRow& without = row_named("profiles, 25 profiles, no collapse");
  CHECK(without.counts.largest_horizon > 2 * with.counts.largest_horizon);
  CHECK(without.profiles.hidden == with.profiles.hidden);
  CHECK(without.profiles.missing == with.profiles.missing);
}

TEST_CASE("larger cells move lines within what is promised") {
  std::vector<float> heights;
  constexpr int kSide = 257;
  for (int row = 0; row < kSide; ++row)
    for (int column = 0; column < kSide; ++column)
      heights.push_back(static_cast<float>(200 * std::sin(0.02 * column) * std::cos(0.017 * row)));
  TerrainData terrain;
  terrain.surface = Grid{kSide, kSide, PlaneLattice{{0, 0}, {30, 0}, {0, -30}},
                         Heights<float>(std::move(heights))};
  AccuracyRow row;
  row.group = "level error";
  row.settings = {.profiles = 25, .level_error_mm = 0.2};
  AccuracySettings settings = small_settings();
  for (const Curvature curvature : {Curvature::off, Curvature::on}) {
    settings.render.map.view.curvature = curvature;
    measure_row(row, settings, terrain);
    REQUIRE(row.detail_mm);
    REQUIRE(row.promise.detail_mm);
    CHECK(*row.promise.detail_mm <= 0.2);
    CHECK(*row.detail_mm > 0.01);
    CHECK(broken_promise(row) == "");
    CHECK(ink_error(row) < 0.1);
  }
  CHECK(name_of(row) == "surface, 25 profiles, level error 0.2 mm");
}

TEST_CASE("a row that breaks its promise fails the run") {
  CHECK_NOTHROW(check_promises(volcano_rows()));
  std::vector<AccuracyRow> rows = volcano_rows();
  AccuracyRow& profiles = rows[1];
  REQUIRE(name_of(profiles) == "profiles, 25 profiles");
  profiles.promise.ink_error = 0; // what the surface promises
  try {
    check_promises(rows);
    FAIL("it was accepted");
  } catch (const Error& error) {
    const std::string message = error.what();
    INFO(message);
    CHECK(message.find("'profiles, 25 profiles'") != std::string::npos);
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

TEST_CASE("the sample's ratio and its standard error") {
  // 100 truly visible, 4 of them missing; 6 more drawn but hidden: 0.1 of the visible length.
  const InkSample ink{200, 0, 100, 6, 4, 0};
  CHECK(std::abs(ink.error() - 0.1) < 1e-15);
  // sqrt(6 * 1 + 4 * 0.81 + 96 * 0.01) / 100
  CHECK(std::abs(ink.standard_error() - std::sqrt(10.2) / 100) < 1e-15);
  CHECK(InkSample{}.error() == 0);
  CHECK(std::abs(ink.smallest_seen() - 0.03) < 1e-15);
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
