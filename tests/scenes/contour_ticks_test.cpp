// SPDX-License-Identifier: GPL-3.0-or-later
// Ticks of contours: a pit has them, pointing into it, a summit and what the border cuts have none.
#include "geometry/error.hpp"
#include "hidden_lines/contour_ticks.hpp"
#include "hidden_lines/ground_lines.hpp"
#include "map/draw_map.hpp"
#include "placing/placed_view.hpp"
#include "tests/catch.hpp"
#include "tests/scenes/look_down.hpp"
#include "tests/scenes/random_scene.hpp"
#include "tests/support/grid_of.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

namespace orograph::contour_ticks_test {
namespace {

constexpr int kSide = 81;
constexpr double kCell_m = 10;

// A cone around a vertex: 1 m up or down in 1 m.
TerrainData cone(Vec2 top, double slope) {
  std::vector<float> heights;
  for (int r = 0; r < kSide; ++r)
    for (int c = 0; c < kSide; ++c)
      heights.push_back(
          static_cast<float>(500 + slope * kCell_m * std::hypot(c - top.x, r - top.y)));
  TerrainData terrain;
  terrain.surface =
      Grid{kSide, kSide, PlaneLattice{{0, 0}, {kCell_m, 0}, {0, -kCell_m}}, std::move(heights)};
  return terrain;
}

MapSpec spec_from(double elevation_deg) {
  MapSpec spec;
  spec.style.layers = {"contours"};
  spec.style.contours.levels = {495, 575, 655, 735, 815};
  spec.style.contours.ticks = true;
  spec.view.projection = Projection::orthographic;
  spec.view.from_elevation = Angle::degrees(elevation_deg);
  spec.view.exaggeration = 1;
  return spec;
}

// Ticks as chains of points.
struct Tick {
  std::uint32_t feature;
  std::vector<ProfilePoint> points;
};

std::vector<Tick> ticks_of(const GroundLines& lines, std::uint32_t vertices) {
  std::vector<Tick> out;
  std::uint32_t last = 0;
  for (const GroundLine& line : lines.lines) {
    if (!lines.features[line.feature].is_tick) continue;
    if (out.empty() || line.ends.from != last)
      out.push_back({line.feature, {lines.points[line.ends.from - vertices]}});
    last = line.ends.to;
    out.back().points.push_back(lines.points[last - vertices]);
  }
  return out;
}

Vec2 page_of(const PlacedView& placed, ProfilePoint p) {
  return placed.to_page.at(project_homogeneous(placed.view, p));
}

std::size_t tick_count(const TerrainData& terrain, const MapSpec& spec) {
  const PlacedView placed = placed_view(terrain, spec);
  return ticks_of(ground_lines_of(terrain, placed, spec.style), kSide * kSide).size();
}

} // namespace

TEST_CASE("a pit has ticks, evenly, that point down into it") {
  const TerrainData pit = cone({40, 40}, 1);
  // From lower down the picture ends above the bottom, which nobody sees.
  for (const double elevation_deg : {90.0, 60.0}) {
    const MapSpec spec = spec_from(elevation_deg);
    const PlacedView placed = placed_view(pit, spec);
    const GroundLines lines = ground_lines_of(pit, placed, spec.style);
    const EdgeEnds ends(pit.surface, placed.view, {lines.points});
    // On the page, by height: the contour's length, which its ticks part.
    std::map<double, double> around_mm;
    for (const GroundLine& line : lines.lines) {
      const GroundFeature& feature = lines.features[line.feature];
      if (feature.is_tick) continue;
      const auto [from, to] = ends(line.ends);
      around_mm[std::get<double>(feature.attributes.front().value)] +=
          length(page_of(placed, from) - page_of(placed, to));
    }
    std::map<double, std::size_t> counts;
    const ProfilePoint bottom = to_profile_frame(placed.view, {40 * kCell_m, -40 * kCell_m, 500});
    for (const Tick& tick : ticks_of(lines, kSide * kSide)) {
      const double height = std::get<double>(lines.features[tick.feature].attributes.front().value);
      ++counts[height];
      const ProfilePoint first = tick.points.front(), last = tick.points.back();
      CHECK(std::abs(first.z - height) <= 1e-9);
      CHECK(last.z < first.z);
      CHECK(std::hypot(last.u - bottom.u, last.v - bottom.v) <
            std::hypot(first.u - bottom.u, first.v - bottom.v));
      // Neither the middle nor the next contour is near.
      const double mm = length(page_of(placed, last) - page_of(placed, first));
      if (elevation_deg == 90) {
        CHECK(mm <= kTick_mm + 1e-9);
        CHECK(mm >= kTick_mm - 1e-6);
      }
    }
    // 815 m is cut off by the border: its circle would have a radius of 315 m of 400.
    CHECK(counts.size() == 4);
    for (const auto& [height, count] : counts)
      CHECK(count == static_cast<std::size_t>(std::round(around_mm[height] / kTicksApart_mm)));
  }
}

TEST_CASE("a summit has no ticks, nor has a hollow that the border cuts") {
  MapSpec spec = spec_from(60);
  CHECK(tick_count(cone({40, 40}, 1), spec) > 100);
  spec.style.contours.levels = {100, 200, 300, 400};
  CHECK(tick_count(cone({40, 40}, -1), spec) == 0);
  spec.style.contours.levels = {575, 655, 735};
  CHECK(tick_count(cone({0, 40}, 1), spec) == 0);
  spec.style.contours.levels = {505}; // a little one, as a whole in the frame
  CHECK(tick_count(cone({40, 40}, 1), spec) == 4);
  spec.style.contours.ticks = false;
  CHECK(tick_count(cone({40, 40}, 1), spec) == 0);
}

TEST_CASE("ticks start on their contours and end above the next ones") {
  std::size_t count = 0;
  for (std::uint64_t seed = 1; seed <= last_seed(60); ++seed) {
    Random random(seed);
    RandomScene scene = random_scene(seed, 40);
    Style& style = scene.spec.style;
    style.layers = {"contours"};
    style.contours.ticks = true;
    style.contours.index_every = 0;
    style.contours.interval.reset();
    if (seed % 3 == 1) look_down(scene.spec, scene.terrain, random);
    INFO("seed " << seed << ": " << scene.what);
    try {
      const PlacedView placed = placed_view(scene.terrain, scene.spec);
      const GroundLines lines = ground_lines_of(scene.terrain, placed, style);
      const ContourLevels levels = contour_levels(scene.terrain, style.contours);
      const auto vertices = static_cast<std::uint32_t>(vertex_count(scene.terrain.surface));
      for (const Tick& tick : ticks_of(lines, vertices)) {
        const double height =
            std::get<double>(lines.features[tick.feature].attributes.front().value);
        const auto level = std::ranges::find(levels.heights, height) - levels.heights.begin();
        const double height_m = levels.heights_m[static_cast<std::size_t>(level)];
        const double z_of_m = placed.view.exaggeration;
        CHECK(std::abs(tick.points.front().z - height_m * z_of_m) <=
              1e-9 * (1 + std::abs(height_m * z_of_m)));
        for (std::size_t i = 1; i < tick.points.size(); ++i)
          CHECK(tick.points[i].z <= tick.points[i - 1].z + 1e-9);
        if (level > 0)
          CHECK(tick.points.back().z >
                levels.heights_m[static_cast<std::size_t>(level) - 1] * z_of_m);
        ++count;
      }
    } catch (const Error&) { // an eye under the ground, or a view of nothing
      continue;
    }
  }
  CHECK(count > enough(500));
}

} // namespace orograph::contour_ticks_test
