// SPDX-License-Identifier: GPL-3.0-or-later
// What is measured of a small terrain's drawings, and how it keeps what is promised.
#include "dem/read/read_raster.hpp"
#include "measure/accuracy.hpp"
#include "tests/catch.hpp"

#include <algorithm>
#include <cmath>

using namespace orograph;

namespace {

const AccuracySpec kSmall{.profiles = {25}, .probes = 2000, .repeats = 1};

const std::vector<AccuracyRow>& volcano_rows() {
  static const std::vector<AccuracyRow> rows = [] {
    const std::vector<std::string> inputs{OROGRAPH_SOURCE_DIR "/data_samples/volcano.tif"};
    const MeasuredTerrain terrain{inputs, {}, read_rasters(inputs, {})};
    std::vector<AccuracyRow> measured = accuracy_rows(kSmall, terrain);
    for (AccuracyRow& row : measured) measure_row(row, kSmall, terrain, {});
    return measured;
  }();
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

TEST_CASE("simplification is measured, and stays within its promise", "[unsanitized]") {
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

TEST_CASE("arithmetic is measured against exact arithmetic", "[unsanitized]") {
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
  const MeasuredTerrain measured{{}, {}, std::move(terrain)};
  MapSpec map;
  for (const Curvature curvature : {Curvature::off, Curvature::on}) {
    map.view.curvature = curvature;
    measure_row(row, kSmall, measured, map);
    REQUIRE(row.detail_mm);
    REQUIRE(row.promise.detail_mm);
    CHECK(*row.promise.detail_mm <= 0.2);
    CHECK(*row.detail_mm > 0.01);
    CHECK(broken_promise(row) == "");
    CHECK(ink_error(row) < 0.1);
  }
  CHECK(name_of(row) == "surface, 25 profiles, level error 0.2 mm");
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
