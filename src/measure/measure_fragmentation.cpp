// SPDX-License-Identifier: GPL-3.0-or-later
// One row's runs: with collapse, without, and in exact arithmetic.
#include "hidden_lines/sector_pass.hpp"
#include "hidden_lines/surface_lines.hpp"
#include "map/draw_map.hpp"
#include "measure/fragmentation.hpp"
#include "placing/sector.hpp"
#include "reference/exact_clip.hpp"

#include <algorithm>
#include <chrono>
#include <limits>

namespace orograph {
namespace {

MapSpec spec_of(const FragmentationRow& row, const MapSpec& map) {
  MapSpec out = map;
  out.style.occluder = row.occluder;
  out.view.from_azimuth = Angle::degrees(row.azimuth_deg);
  out.view.from_elevation = Angle::degrees(row.elevation_deg);
  out.style.plan = ProfileCount{row.profiles};
  out.style.light.reset();       // which changes no horizon
  out.style.silhouette_jump = 0; // which decides what is drawn, after all is clipped
  // With the paper's occluders the profiles are all there is.
  if (row.occluder == Occluder::profiles) out.style.layers = {"profiles"};
  return out;
}

// Counts the horizon's pieces.
class SizeMeter : public LineObserver {
public:
  explicit SizeMeter(FragmentationRun& run) : run_(run) {}

  void begin_sector() { sector_most_ = sector_last_ = 0; }
  void end_sector() {
    run_.at_end += sector_last_;
    run_.at_most += sector_most_;
  }
  void take(std::size_t size) {
    run_.after.push_back(static_cast<std::uint32_t>(size));
    sector_last_ = size;
    sector_most_ = std::max(sector_most_, size);
  }

  void see(const SeenProfile& seen) override {
    const auto& visible = seen.visible;
    visible_ += visible.size();
  }
  void see(const SeenLines&) override {}
  void see_horizon(const Sector&, const Horizon& horizon) override { take(horizon.size()); }

  std::uint64_t visible() const { return visible_; }

private:
  FragmentationRun& run_;
  std::size_t sector_most_ = 0, sector_last_ = 0;
  std::uint64_t visible_ = 0;
};

// Raises the true horizon by what the run's own horizon is raised by, and compares the two.
class LeastMeter : public LineObserver {
public:
  LeastMeter(LeastRun& least, bool surface, double tolerance_mm)
      : least_(least), sizes_(least.run), surface_(surface), tolerance_mm_(tolerance_mm) {}

  void begin_sector() {
    sizes_.begin_sector();
    exact_ = std::make_unique<ExactHorizon>();
    occluders_.clear();
    least_.at_end += at_end_;
    at_end_ = {};
  }
  void end_sector() { sizes_.end_sector(); }
  void finish() { least_.at_end += at_end_; }
  std::vector<HorizonPiece>& occluders() { return occluders_; }

  void see(const SeenProfile& seen) override {
    const auto& segments = seen.segments;
    using Clock = std::chrono::steady_clock;
    const auto start = Clock::now();
    if (surface_) {
      exact_->raise(occluders_);
    } else {
      // The exact clip compares what has an extent in X: no walls.
      std::vector<Segment> wide;
      for (const Segment& s : segments)
        if (s.x0 < s.x1) wide.push_back(s);
      exact_->clip({wide, Role::drawn_occluder});
    }
    least_.run.seconds += std::chrono::duration<double>(Clock::now() - start).count();
    least_.run.work += exact_->size();
    occluders_.clear();
  }
  void see(const SeenLines&) override {}
  void see_horizon(const Sector& sector, const Horizon& horizon) override {
    const Horizon exact = exact_->pieces();
    sizes_.take(exact.size());
    // The surface's occluders are compared exactly.
    TieTolerance tolerance = tie_tolerance(sector, tolerance_mm_);
    if (surface_) tolerance.mm = tolerance.greatest_y = 0;
    at_end_ = compare_horizons(horizon, exact, tolerance);
    least_.differences += at_end_;
  }

private:
  LeastRun& least_;
  SizeMeter sizes_;
  bool surface_;
  double tolerance_mm_;
  std::unique_ptr<ExactHorizon> exact_;
  std::vector<HorizonPiece> occluders_;
  HorizonDifferences at_end_;
};

struct MeasuredScene {
  const TerrainData& terrain;
  const PlacedView& scene;
  const LinesOfView& lines;
  const Style& style;
};

struct Totals {
  Counts counts;
  StageSeconds seconds;
};

template <class Meter>
Totals run(const MeasuredScene& s, const Instruments& instruments, Meter& meter) {
  Totals out;
  StageSeconds& seconds = out.seconds;
  seconds.facing = seconds.cut = seconds.project = seconds.clip = seconds.check = seconds.layout =
      0;
  for (const Sector& sector : s.scene.sectors) {
    meter.begin_sector();
    sector_pass(s.terrain, s.scene, sector, s.lines, nullptr, s.style, instruments, nullptr,
                {out.counts, seconds}, [] {});
    meter.end_sector();
  }
  return out;
}

FragmentationRun timed(const MeasuredScene& s, bool collapse, int repeats) {
  FragmentationRun out;
  out.seconds = std::numeric_limits<double>::infinity();
  for (int i = 0; i < repeats; ++i) {
    FragmentationRun once;
    SizeMeter meter(once);
    const Totals totals =
        run(s, {.observers = {&meter}, .collapse = collapse, .one_list = true}, meter);
    once.work = totals.counts.pieces_before_collapse;
    once.seconds = std::min(out.seconds, totals.seconds.clip);
    out = std::move(once);
  }
  return out;
}

} // namespace

void measure_row(FragmentationRow& row, const FragmentationSpec& spec, const TerrainData& terrain,
                 const MapSpec& map) {
  const MapSpec drawn = spec_of(row, map);
  const PlacedView scene = placed_view(terrain, drawn);
  const LinesOfView lines{lines_of(terrain, scene, drawn.style), {}, std::nullopt};
  const MeasuredScene measured{terrain, scene, lines, drawn.style};
  const bool surface = row.occluder == Occluder::surface;

  FragmentationRun counted;
  SizeMeter meter(counted);
  std::vector<HorizonPiece> occluders;
  row.segments =
      run(measured, {.observers = {&meter}, .one_list = true, .occluders = &occluders}, meter)
          .counts.segments;
  row.visible = meter.visible();
  row.occluders = surface ? occluders.size() : row.segments;
  row.collapsed = timed(measured, true, spec.repeats);
  if (row.occluders <= static_cast<std::uint64_t>(spec.fragmented_segments))
    row.fragmented = timed(measured, false, spec.repeats);
  if (row.occluders <= static_cast<std::uint64_t>(spec.exact_segments)) {
    LeastMeter exact(row.least.emplace(), surface, drawn.style.visibility_tolerance_mm);
    run(measured, {.observers = {&exact}, .one_list = true, .occluders = &exact.occluders()},
        exact);
    exact.finish();
  }
}

} // namespace orograph
