// SPDX-License-Identifier: GPL-3.0-or-later
// The stages that are measured one by one are those of a drawing: put together they make it.
#include "bench/one_a_row.hpp"
#include "bench/scenes.hpp"
#include "bench/stages/front_to_back.hpp"
#include "bench/stages/stages.hpp"
#include "draw/round_drawing.hpp"
#include "hidden_lines/strip_pass.hpp"
#include "hidden_lines/strips.hpp"
#include "hidden_lines/surface_lines.hpp"
#include "map/draw_map.hpp"
#include "tests/catch.hpp"

#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

using namespace orograph;

namespace {

// The northernmost rows of the benchmarks' mountains.
Grid mountains(int columns, int rows) {
  Grid grid = fractal_terrain(columns);
  const float* const heights = std::get<Heights<float>>(grid.heights_m).data();
  grid.heights_m = std::vector<float>(heights, heights + static_cast<std::size_t>(columns) *
                                                             static_cast<std::size_t>(rows));
  grid.rows = rows;
  return grid;
}

// Wide enough for several strips.
StagedView wide_view(double azimuth_deg, double elevation_deg) {
  Grid grid = mountains(1000, 60);
  MapSpec spec = one_profile_a_row(grid, azimuth_deg, elevation_deg);
  return {std::move(grid), std::move(spec)};
}

bool same(const LinePart& a, const LinePart& b) {
  return a.line == b.line && a.t_begin == b.t_begin && a.t_end == b.t_end;
}

} // namespace

TEST_CASE("profiles taken stage by stage are those of the drawing", "[bench]") {
  for (const auto& [azimuth_deg, elevation_deg] : {std::pair{180., 25.}, {182., 5.}}) {
    const StagedView view = wide_view(azimuth_deg, elevation_deg);
    std::vector<ProfileInWork> profiles = clipped_profiles(view);
    CHECK(profiles.front().by_strip.size() > 1);
    Layer layer = laid_out(view, view.strokes, profiles);
    round_to_page_step(layer);
    const Map drawn = draw_map(view.terrain, view.scene, view.spec, [](double) {});
    const Layer& whole = drawn.drawing.layers.front();
    CHECK(whole.page_mm.size() > 1000);
    CHECK(layer.page_mm == whole.page_mm);
    CHECK(std::ranges::equal(layer.strokes, whole.strokes, {}, &Stroke::point_count,
                             &Stroke::point_count));
  }
}

TEST_CASE("lines taken stage by stage are those of the pass in strips", "[bench]") {
  for (const auto& [azimuth_deg, elevation_deg] : {std::pair{180., 25.}, {182., 5.}}) {
    const StagedView view = wide_view(azimuth_deg, elevation_deg);
    Style drawing = view.spec.style;
    drawing.layers = {"silhouettes", "border"}; // some of which is in the last plane
    const std::vector<EdgeLine> lines = lines_of(view.terrain, view.scene, drawing);
    PassMeters meters;
    PassFound found = pass_front_to_back(view, lines, meters, [](const ProfileInWork&) {});
    join(found.visible);
    Counts counts;
    StageSeconds seconds;
    seconds.cut = seconds.project = seconds.clip = seconds.layout = seconds.facing = 0;
    const SectorParts whole = strips_pass(
        view.work_with(lines), [](ProfileInWork&) {}, [](ProfileInWork&) {}, counts, seconds);
    CHECK(whole.visible.size() > 1000);
    CHECK(std::ranges::equal(found.visible, whole.visible, same));
    CHECK(found.cut_vertices == counts.cut_vertices);
  }
}

TEST_CASE("each stage does the same whenever it runs, and says what it costs", "[bench]") {
  Grid grid = mountains(60, 60);
  MapSpec spec = one_profile_a_row(grid, 180, 25);
  const StagedView view(std::move(grid), std::move(spec));
  for (const NamedStage& named : all_stages()) {
    INFO(named.name);
    Stage stage = named.of(view);
    Meter first, second;
    const std::size_t vertices = stage(first);
    CHECK(vertices > 100);
    CHECK(stage(second) == vertices);
    CHECK(second.seconds > 0);
    const std::string_view name = named.name;
    if (name == "cut" || name == "project" || name == "simplify") // "no allocation once warm"
      CHECK(second.allocations.count == 0);
    else
      CHECK(second.allocations.count > 0);
  }
}
