// SPDX-License-Identifier: GPL-3.0-or-later
// One row's runs: one that measures lengths, one that asks the ray walk, and those that are timed.
#include "cli/accuracy/accuracy.hpp"
#include "cli/accuracy/exact_run.hpp"
#include "cli/accuracy/visible_record.hpp"
#include "cli/cut_by_view.hpp"
#include "cli/draw_scene.hpp"
#include "cli/error_budget.hpp"
#include "dem/read/read_raster.hpp"
#include "dem/reframe.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

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
                           const Terrain& full) {
  RenderSettings out = render;
  out.occluder = row.settings.occluder;
  out.plan = ProfileCount{row.settings.profiles.value_or(one_a_cell(full.surface))};
  out.simplify_mm = row.settings.simplify_mm;
  out.reading.overview = row.settings.overview;
  if (row.settings.arithmetic == Arithmetic::exact) out.layers = {"profiles"};
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

class AllOf : public LineObserver {
public:
  explicit AllOf(std::vector<LineObserver*> observers) : observers_(std::move(observers)) {}
  void add(LineObserver& observer) { observers_.push_back(&observer); }

  void see(const Sector& sector, const Profile& profile, const std::vector<Segment>& segments,
           const std::vector<Piece>& visible) override {
    for (LineObserver* observer : observers_) observer->see(sector, profile, segments, visible);
  }
  void see(const Sector& sector, const LineSweep& lines,
           const std::vector<LinePart>& visible) override {
    for (LineObserver* observer : observers_) observer->see(sector, lines, visible);
  }

private:
  std::vector<LineObserver*> observers_;
};

void keep_least(double& least, double seconds) {
  if (!(least <= seconds)) least = seconds; // also where nothing was measured yet
}

void keep_least(SecondsReport& least, const SecondsReport& run) {
  keep_least(least.facing, run.facing);
  keep_least(least.cut, run.cut);
  keep_least(least.project, run.project);
  keep_least(least.clip, run.clip);
  keep_least(least.layout, run.layout);
}

} // namespace

void measure_row(AccuracyRow& row, const AccuracySettings& settings, const Terrain& full) {
  const RenderSettings render = settings_of(row, settings.render, full);
  std::optional<Terrain> overview;
  if (row.settings.overview) {
    overview = read_rasters(render.inputs, render.reading);
    if (const auto& earth = full.map.earth)
      reframe(*overview, earth->local.origin_lon_deg(), earth->local.origin_lat_deg(),
              earth->exaggeration);
    if (auto cut = cut_by_view(*overview, render)) overview = std::move(cut);
  }
  const Terrain& terrain = overview ? *overview : full;
  const Surface* full_heights = overview ? &full.surface : nullptr;
  const Scene scene = place_scene(terrain, render);
  row.profile_count = scene.depths_m.size();
  row.promise = promise_of(row.settings, error_budget(terrain, scene, render));

  const bool exact = row.settings.arithmetic == Arithmetic::exact;
  const auto run = [&](const RenderSettings& with, LineObserver* observer) {
    if (exact) return draw_exactly(terrain, scene, observer);
    const Instruments instruments{.observer = observer,
                                  .collapse = row.settings.collapse,
                                  .single_precision =
                                      row.settings.arithmetic == Arithmetic::float32,
                                  .beyond_page = true};
    return draw_scene(
        terrain, scene, with, [](double) {}, instruments);
  };

  // Lengths don't depend on what is hidden, so double precision measures those of any row.
  RenderSettings unsimplified = render;
  unsimplified.simplify_mm = 0;
  InkMeter lengths(terrain.surface, scene, render, kNever, full_heights);
  const DrawnScene whole = draw_scene(terrain, scene, unsimplified, [](double) {},
                                      {.observer = &lengths, .beyond_page = true});
  check_not_empty(whole, render);

  // Profiles get the points that were asked for, whether other lines are drawn too or not: rows
  // with the same profiles are asked of the same points.
  const double stride_mm = lengths.profiles().length_mm / settings.probes;
  InkMeter ink(terrain.surface, scene, render, stride_mm, full_heights);
  const auto ends = static_cast<std::uint64_t>(settings.probes / kProbesAnEnd);
  EndMeter end_meter(terrain.surface, scene, render,
                     {ends / 2 / scene.depths_m.size() + 1, ends / 2 + 1});
  VisibleRecord visible(scene);
  AllOf observers({&ink});
  if (!overview) observers.add(end_meter);
  if (row.group == "arithmetic") observers.add(visible);
  const DrawnScene probed = run(render, &observers);

  row.counts = probed.counts;
  row.profiles = ink.profiles();
  row.lines = ink.lines();
  row.ends = end_meter.ends();
  if (overview) row.detail_mm = ink.farthest_mm();
  if (exact) {
    row.seconds = probed.seconds; // too slow to be repeated
  } else {
    row.simplified = simplified_distance(probed.drawing, whole.drawing);
    for (int i = 0; i < settings.repeats; ++i)
      keep_least(row.seconds, run(render, nullptr).seconds);
    if (row.group == "arithmetic") {
      VisibleRecord exactly(scene);
      draw_exactly(terrain, scene, &exactly);
      row.arithmetic_mm = longest_difference_mm(visible, exactly);
    }
  }
  SecondsReport& seconds = row.seconds;
  seconds.total = seconds.facing + seconds.cut + seconds.project + seconds.clip + seconds.layout;
}

} // namespace orograph
