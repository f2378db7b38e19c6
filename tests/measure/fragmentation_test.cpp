// SPDX-License-Identifier: GPL-3.0-or-later
// How horizons fragment, against brute force.
#include "dem/mesh/verify_tin.hpp"
#include "map/draw_map.hpp"
#include "measure/fragmentation.hpp"
#include "measure/growth.hpp"
#include "measure/worst_cases.hpp"
#include "tests/catch.hpp"
#include "tests/measure/quarry_rows.hpp"
#include "tests/support/envelope_size.hpp"
#include "tests/support/made_grid.hpp"

#include <algorithm>

using namespace orograph;

namespace {

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

double exponent(const std::vector<Growth>& growths, const std::string& scene, Occluder occluder,
                const std::string& measure) {
  for (const Growth& growth : growths)
    if (growth.like.scene == scene && growth.like.occluder == occluder)
      for (const auto& [name, value] : growth.exponents)
        if (name == measure) return value.value();
  FAIL(scene << " has no " << measure);
  return 0;
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
          measure_row(row, FragmentationSpec{}, terrain, {});
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
  FragmentationSpec spec;
  spec.exact_segments = 100;
  spec.fragmented_segments = 200;
  const TerrainData gate = gate_before_ridges(4);
  FragmentationRow row = row_of(Occluder::profiles, 180, 10, 4);
  measure_row(row, spec, gate, {});
  REQUIRE(row.occluders > 100);
  REQUIRE(row.occluders <= 200);
  CHECK_FALSE(row.least);
  CHECK(row.fragmented);
  CHECK(broken_promise(row).empty()); // not known
  spec.fragmented_segments = 100;
  row = row_of(Occluder::profiles, 180, 10, 4);
  measure_row(row, spec, gate, {});
  CHECK_FALSE(row.fragmented);
}

TEST_CASE("the worst cases grow as they are made to", "[unsanitized]") {
  CHECK_FALSE(verify(std::get<Tin>(comb_before_slope(5).surface)));
  FragmentationSpec spec;
  spec.worst_case = 128;
  std::vector<FragmentationRow> rows = worst_case_rows(spec);
  REQUIRE(rows.size() == 20); // two scenes, two occluders, sizes 8, 16, 32, 64, 128
  for (FragmentationRow& row : rows) {
    measure_row(row, spec, worst_case_terrain(row), {});
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
