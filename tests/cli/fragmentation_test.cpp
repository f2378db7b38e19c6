// SPDX-License-Identifier: GPL-3.0-or-later
// `orograph fragmentation`: its measures against brute force, what it writes, and its refusals.
#include "cli/fragmentation/fragmentation.hpp"
#include "cli/fragmentation/fragmentation_report.hpp"
#include "cli/fragmentation/worst_cases.hpp"
#include "cli/options/options.hpp"
#include "dem/mesh/verify_tin.hpp"
#include "dem/read/read_terrain.hpp"
#include "geometry/error.hpp"
#include "map/draw_map.hpp"
#include "tests/catch.hpp"
#include "tests/cli/made_files.hpp"
#include "tests/cli/run_program.hpp"
#include "tests/support/envelope_size.hpp"
#include "tests/support/made_grid.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <sstream>

using namespace orograph;

namespace {

const std::string kQuarry = OROGRAPH_SOURCE_DIR "/data_samples/quarry_points.csv";

// Writes down what the horizon is made of, and how many pieces brute force finds behind each
// profile.
class EnvelopeCounter : public LineObserver {
public:
  explicit EnvelopeCounter(bool surface) : surface_(surface) {}

  std::vector<HorizonPiece> occluders;
  std::vector<std::uint32_t> after;

  void see(const SeenProfile& seen) override {
    const auto& segments = seen.segments;
    if (surface_)
      for (const HorizonPiece& piece : occluders)
        in_front_.push_back({piece.source, piece.x_begin, piece.x_end});
    else
      for (const Segment& s : segments) in_front_.push_back({s, s.x0, s.x1});
    occluders.clear();
    after.push_back(static_cast<std::uint32_t>(envelope_size(in_front_)));
  }
  void see(const SeenLines&) override {}

private:
  bool surface_;
  std::vector<EnvelopePart> in_front_;
};

TerrainData terrain_of(Grid grid) {
  return {std::move(grid), {}, "made", {}, {}, {}, 0};
}

FragmentationRow row_of(Occluder occluder, double azimuth_deg, double elevation_deg, int profiles) {
  FragmentationRow row;
  row.scene = "terrain";
  row.occluder = occluder;
  row.azimuth_deg = azimuth_deg;
  row.elevation_deg = elevation_deg;
  row.profiles = profiles;
  return row;
}

std::vector<std::uint32_t> brute_force(const FragmentationRow& row, const TerrainData& terrain) {
  MapSpec render;
  render.style.occluder = row.occluder;
  render.view.from_azimuth = Angle::degrees(row.azimuth_deg);
  render.view.from_elevation = Angle::degrees(row.elevation_deg);
  render.style.plan = ProfileCount{row.profiles};
  EnvelopeCounter counter(row.occluder == Occluder::surface);
  const PlacedView scene = placed_view(terrain, render);
  REQUIRE(scene.sectors.size() == 1);
  draw_map(terrain, scene, render, [](double) {},
           {.observers = {&counter}, .one_list = true, .occluders = &counter.occluders});
  return counter.after;
}

const std::vector<FragmentationRow>& quarry_rows() {
  static const std::vector<FragmentationRow> rows = [] {
    FragmentationSettings spec;
    spec.render.inputs = {kQuarry};
    spec.profiles = {15, 60};
    spec.elevations_deg = {25};
    spec.azimuths_deg = {180};
    const TerrainData terrain = read_terrain(spec.render.inputs, spec.render.reading);
    std::vector<FragmentationRow> out = fragmentation_rows(spec);
    for (FragmentationRow& row : out) measure_row(row, spec, terrain);
    return out;
  }();
  return rows;
}

double exponent(const std::vector<Growth>& growths, const std::string& scene, Occluder occluder,
                const std::string& measure) {
  for (const Growth& growth : growths)
    if (growth.like.scene == scene && growth.like.occluder == occluder)
      for (const auto& [name, value] : growth.exponents)
        if (name == measure) return value.value();
  FAIL(scene << " has no " << measure);
  return 0;
}

std::string refusal(const std::vector<std::string>& arguments) {
  try {
    parse_fragmentation(arguments);
  } catch (const UsageError& error) {
    return error.what();
  }
  return "accepted";
}

} // namespace

TEST_CASE("horizons have as many pieces as brute force finds, behind each profile") {
  std::size_t horizons = 0;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    Random random(seed);
    const GridLattice lattice{9, 9, {0, 80}, {10, 0}, {0, -10}};
    const TerrainData terrain =
        terrain_of(made_grid(random, lattice, {0, 25, seed == 3 ? 0.1 : 0, false, true}));
    for (const Occluder occluder : {Occluder::profiles, Occluder::surface})
      for (const double azimuth_deg : {180.0, 90.0, 217.0})
        for (const double elevation_deg : {4.0, 30.0}) {
          FragmentationRow row = row_of(occluder, azimuth_deg, elevation_deg, 7);
          INFO(name_of(row) << ", seed " << seed);
          measure_row(row, FragmentationSettings{}, terrain);
          const auto counted = brute_force(row, terrain);
          REQUIRE(row.least);
          REQUIRE(row.fragmented);
          CHECK(row.collapsed.after == counted);
          CHECK(row.least->run.after == counted);
          CHECK(broken_promise(row).empty());
          for (std::size_t i = 0; i < counted.size(); ++i)
            CHECK(row.fragmented->after[i] >= counted[i]);
          CHECK(row.collapsed.at_end == counted.back());
          CHECK(row.collapsed.at_most == *std::max_element(counted.begin(), counted.end()));
          horizons += counted.size();
        }
  }
  CHECK(horizons == 4 * 2 * 3 * 2 * 7);
}

TEST_CASE("the paper's experiment: a triangulated terrain, 60 profiles") {
  // Rows: profiles hide, then the surface; 15 and 60 profiles.
  const auto& rows = quarry_rows();
  REQUIRE(rows.size() == 4);
  const FragmentationRow& row = rows[1];
  REQUIRE(row.profiles == 60);
  REQUIRE(row.least);
  CHECK(row.collapsed.at_end == row.least->run.at_end);
  CHECK(row.fragmented->at_end > 12 * row.collapsed.at_end); // the paper: 750 for 60
  // Each segment adds about a piece where nothing is joined.
  CHECK(row.fragmented->at_end >= row.segments);
  CHECK(row.fragmented->at_end < 1.1 * static_cast<double>(row.segments));
  CHECK(row.fragmented->work > 9 * row.collapsed.work);
  CHECK(row.fragmented->after.size() == 60);
  for (const FragmentationRow& each : rows) {
    INFO(name_of(each));
    CHECK(broken_promise(each).empty());
    CHECK(each.least->differences.fragments == 0);
    CHECK(each.fragmented->at_end > each.collapsed.at_end);
  }
}

TEST_CASE("what is too large is not run") {
  FragmentationSettings spec;
  spec.exact_segments = 100;
  spec.fragmented_segments = 200;
  const TerrainData gate = gate_before_ridges(4);
  FragmentationRow row = row_of(Occluder::profiles, 180, 10, 4);
  measure_row(row, spec, gate);
  REQUIRE(row.occluders > 100);
  REQUIRE(row.occluders <= 200);
  CHECK_FALSE(row.least);
  CHECK(row.fragmented);
  CHECK(broken_promise(row).empty()); // not known
  spec.fragmented_segments = 100;
  row = row_of(Occluder::profiles, 180, 10, 4);
  measure_row(row, spec, gate);
  CHECK_FALSE(row.fragmented);
  CHECK(fragmentation_csv({row}).find(",,,,") != std::string::npos);
}

TEST_CASE("the worst cases grow as they are made to") {
  CHECK_FALSE(verify(std::get<Tin>(comb_before_slope(5).surface)));
  FragmentationSettings spec;
  spec.worst_case = 128;
  std::vector<FragmentationRow> rows = worst_case_rows(spec);
  REQUIRE(rows.size() == 20); // two scenes, two occluders, sizes 8, 16, 32, 64, 128
  for (FragmentationRow& row : rows) {
    measure_row(row, spec, worst_case_terrain(row));
    INFO(name_of(row));
    CHECK(broken_promise(row).empty());
  }
  const auto growths = growth_of(rows);
  const std::string gate = rows.front().scene, comb = rows.back().scene;
  const auto near = [](double x) { return Approx(x).margin(0.12); };
  using enum Occluder;
  // Linear and quadratic without collapse, constant and linear with it.
  for (const Occluder occluder : {profiles, surface}) {
    CHECK(exponent(growths, gate, occluder, "occluders") == near(1));
    CHECK(exponent(growths, gate, occluder, "pieces_without") == near(1));
    CHECK(exponent(growths, gate, occluder, "pieces_with") == near(0));
    CHECK(exponent(growths, gate, occluder, "pieces_least") == near(0));
    CHECK(exponent(growths, gate, occluder, "work_with") == near(1));
  }
  CHECK(exponent(growths, gate, profiles, "work_without") == near(2));
  CHECK(exponent(growths, gate, surface, "work_without") > 1.7);
  // What is visible is itself quadratic.
  CHECK(exponent(growths, comb, profiles, "occluders") == Approx(1).margin(0.2));
  CHECK(exponent(growths, comb, profiles, "visible_pieces") > 1.6);
  CHECK(exponent(growths, comb, profiles, "pieces_with") == Approx(1).margin(0.2));
  CHECK(exponent(growths, comb, profiles, "work_without") > 2.3);

  spec.worst_case = 0;
  CHECK(worst_case_rows(spec).empty());
}

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
