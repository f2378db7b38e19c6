// SPDX-License-Identifier: GPL-3.0-or-later
// One row's runs: one that measures lengths, one that asks the ray walk, and those that are timed.
#include "cli/accuracy/accuracy.hpp"
#include "cli/accuracy/exact_run.hpp"
#include "cli/accuracy/visible_record.hpp"
#include "cli/render.hpp"
#include "dem/read/read_raster.hpp"
#include "dem/terrain.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "map/draw_map.hpp"
#include "map/error_budget.hpp"
#include "placing/terrain_of_view.hpp"

namespace orograph {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
// Points for each end that is asked about, which takes a few hundred rays.
constexpr int kProbesAnEnd = 40;

// One profile a grid row, or as far apart as a TIN's triangles are large.
int one_a_cell(const Surface& surface) {
  if (const Grid* grid = std::get_if<Grid>(&surface)) return grid->rows;
  const Box3 box = extent_of(surface).box;
  const double side_m = std::max(box.high.x - box.low.x, box.high.y - box.low.y);
  return static_cast<int>(std::clamp(std::round(side_m / cell_size_m(surface)), 1.0, 10000.0));
}

RenderSettings settings_of(const AccuracyRow& row, const RenderSettings& render,
                           const TerrainData& full) {
  RenderSettings out = render;
  out.map.style.occluder = row.settings.occluder;
  out.map.style.plan = ProfileCount{row.settings.profiles.value_or(one_a_cell(full.surface))};
  out.map.style.simplify_mm = row.settings.simplify_mm;
  out.reading.overview = row.settings.overview;
  if (row.settings.arithmetic == Arithmetic::exact) out.map.style.layers = {"profiles"};
  return out;
}

// Without geodesy, which is a property of the terrain's map and not of the drawing's lines.
RowPromise promise_of(const RowSettings& settings, const ErrorBudget& budget) {
  RowPromise out;
  out.simplified_mm = budget.simplification_mm + budget.rounding_mm;
  if (settings.occluder != Occluder::surface || settings.overview ||
      settings.arithmetic != Arithmetic::float64)
    return out;
  out.ink_error = 0;
  out.displacement_mm = budget.simplification_mm + budget.visibility_tolerance_mm +
                        budget.arithmetic_mm + budget.rounding_mm;
  return out;
}

void keep_least(double& least, double seconds) {
  if (!(least <= seconds)) least = seconds; // also where nothing was measured yet
}

void keep_least(StageSeconds& least, const StageSeconds& run) {
  keep_least(least.facing, run.facing);
  keep_least(least.cut, run.cut);
  keep_least(least.project, run.project);
  keep_least(least.clip, run.clip);
  keep_least(least.layout, run.layout);
}

} // namespace

void measure_row(AccuracyRow& row, const AccuracySettings& settings, const TerrainData& full) {
  const RenderSettings render = settings_of(row, settings.render, full);
  std::optional<TerrainData> overview;
  if (row.settings.overview) {
    overview = read_rasters(render.inputs, render.reading);
    if (const auto& earth = full.map.earth)
      reframe(*overview, earth->local.origin_lon_deg(), earth->local.origin_lat_deg(),
              earth->exaggeration);
    if (auto cut = cut_by_view(*overview, render.map.view)) overview = std::move(cut);
  }
  const TerrainData& terrain = overview ? *overview : full;
  const Surface* full_heights = overview ? &full.surface : nullptr;
  const PlacedView scene = placed_view(terrain, render.map);
  row.profile_count = scene.depths_m.size();
  row.promise = promise_of(row.settings, error_budget(terrain, scene, render.map));

  const bool exact = row.settings.arithmetic == Arithmetic::exact;
  const auto run = [&](const std::vector<LineObserver*>& observers) {
    if (exact) return draw_exactly(terrain, scene, observers);
    const Instruments instruments{.observers = observers,
                                  .collapse = row.settings.collapse,
                                  .single_precision =
                                      row.settings.arithmetic == Arithmetic::float32,
                                  .beyond_page = true};
    return draw_map(
        terrain, scene, render.map, [](double) {}, instruments);
  };

  // Lengths don't depend on what is hidden, so double precision measures those of any row.
  MapSpec unsimplified = render.map;
  unsimplified.style.simplify_mm = 0;
  InkMeter lengths(terrain.surface, scene, render.map, kNever, full_heights);
  const Map whole = draw_map(terrain, scene, unsimplified, [](double) {},
                             {.observers = {&lengths}, .beyond_page = true});
  check_not_empty(whole, render);

  // Profiles get the points that were asked for, whether other lines are drawn too or not: rows
  // with the same profiles are asked of the same points.
  const double stride_mm = lengths.profiles().length_mm / settings.probes;
  InkMeter ink(terrain.surface, scene, render.map, stride_mm, full_heights);
  const auto ends = static_cast<std::uint64_t>(settings.probes / kProbesAnEnd);
  EndMeter end_meter(terrain.surface, scene, render.map,
                     {ends / 2 / scene.depths_m.size() + 1, ends / 2 + 1});
  VisibleRecord visible(scene);
  std::vector<LineObserver*> observers{&ink};
  if (!overview) observers.push_back(&end_meter);
  if (row.group == "arithmetic") observers.push_back(&visible);
  const Map probed = run(observers);

  row.counts = probed.facts.counts;
  row.profiles = ink.profiles();
  row.lines = ink.lines();
  row.ends = end_meter.ends();
  if (overview) row.detail_mm = ink.farthest_mm();
  if (exact) {
    row.seconds = probed.facts.seconds; // too slow to be repeated
  } else {
    row.simplified = simplified_distance(probed.drawing, whole.drawing);
    for (int i = 0; i < settings.repeats; ++i) keep_least(row.seconds, run({}).facts.seconds);
    if (row.group == "arithmetic") {
      VisibleRecord exactly(scene);
      draw_exactly(terrain, scene, {&exactly});
      row.arithmetic_mm = longest_difference_mm(visible, exactly);
    }
  }
  StageSeconds& seconds = row.seconds;
  seconds.total = seconds.facing + seconds.cut + seconds.project + seconds.clip + seconds.layout;
}

} // namespace orograph
