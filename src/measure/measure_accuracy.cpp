// SPDX-License-Identifier: GPL-3.0-or-later
// One row's runs: one that measures lengths, one that asks the ray walk, those that are timed, and
// those in exact arithmetic or with all points that it is compared with.
#include "dem/read/read_raster.hpp"
#include "dem/terrain.hpp"
#include "draw/drawing.hpp"
#include "hidden_lines/instruments.hpp"
#include "map/draw_level.hpp"
#include "map/error_budget.hpp"
#include "map/line_on_page.hpp"
#include "measure/accuracy.hpp"
#include "measure/meters.hpp"
#include "placing/level_of_detail.hpp"
#include "placing/placed_view.hpp"
#include "placing/terrain_of_view.hpp"
#include "profiles/cut_surface.hpp"
#include "profiles/profile.hpp"
#include "reference/exact_clip.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

namespace orograph {
namespace {

constexpr double kNever = kInfinity;
// Points for each end that is asked about, which takes a few hundred rays.
constexpr int kProbesAnEnd = 40;

// One profile a grid row, or as far apart as a TIN's triangles are large.
int one_a_cell(const Surface& surface) {
  if (const Grid* grid = std::get_if<Grid>(&surface)) return grid->rows;
  const Box3 box = extent_of(surface).box;
  const double side_m = std::max(box.high.x - box.low.x, box.high.y - box.low.y);
  return static_cast<int>(std::clamp(std::round(side_m / cell_size_m(surface)), 1.0, 10000.0));
}

MapSpec spec_of(const AccuracyRow& row, const MapSpec& map, const TerrainData& full) {
  MapSpec out = map;
  out.style.occluder = row.settings.occluder;
  out.style.plan = ProfileCount{row.settings.profiles.value_or(one_a_cell(full.surface))};
  out.style.simplify_mm = row.settings.simplify_mm;
  // Strokes are compared one by one: none is cut for its width, joined with others or left out.
  out.style.light.reset();
  out.style.join_mm = 0;
  out.style.min_stroke_mm = 0;
  out.style.detail = {.of_file = !row.settings.level_error_mm,
                      .error_mm = row.settings.level_error_mm};
  if (row.settings.arithmetic == Arithmetic::exact) out.style.layers = {"profiles"};
  return out;
}

// In the frame of the full heights.
TerrainData overview_of(const MeasuredTerrain& terrain, int overview, const TerrainData& full,
                        const ViewSpec& view) {
  ReadOptions reading = terrain.reading;
  reading.overview = overview;
  TerrainData out = read_rasters(terrain.inputs, reading);
  if (const auto& earth = full.map.earth)
    reframe(out, earth->local.origin_lon_deg(), earth->local.origin_lat_deg(), earth->exaggeration);
  if (auto cut = cut_by_view(out, view)) return std::move(*cut);
  return out;
}

// Without geodesy, which is a property of the terrain's map and not of the drawing's lines.
RowPromise promise_of(const RowSettings& settings, const ErrorBudget& budget) {
  RowPromise out;
  out.simplified_mm = budget.simplification_mm + budget.rounding_mm;
  if (settings.level_error_mm) out.detail_mm = budget.level_of_detail_mm;
  if (settings.occluder != Occluder::surface || settings.overview || settings.level_error_mm ||
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

// The seed's method in exact rational arithmetic, to see what arithmetic in double costs: what
// profiles alone hide, by `exact_clip`, is told to the observers and counted, not drawn. Memory:
// all projected profiles.
Map draw_exactly(const TerrainData& terrain, const PlacedView& scene,
                 const std::vector<LineObserver*>& observers) {
  using Clock = std::chrono::steady_clock;
  const auto since = [](Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
  };
  Map out;
  StageSeconds& seconds = out.facts.seconds;
  Counts& counts = out.facts.counts;
  seconds.facing = seconds.cut = seconds.project = seconds.clip = seconds.layout = 0;
  for (const Sector& sector : scene.sectors) {
    const SurfaceCutter cutter(terrain.surface, sector.view, scene.level.triangles,
                               scene.for_cutters);
    std::vector<Profile> profiles(sector.profiles.size());
    std::vector<std::vector<Segment>> segments(sector.profiles.size());
    std::vector<Segment> uprights; // of walls: the exact clip compares what has an extent in X
    std::vector<ExactList> lists;
    for (std::size_t i = 0; i < sector.profiles.size(); ++i) {
      auto start = Clock::now();
      cutter.cut(sector.profiles[i].depth_m, profiles[i]);
      seconds.cut += since(start);
      start = Clock::now();
      project_profile(profiles[i], static_cast<std::uint32_t>(sector.profiles[i].number),
                      sector.view, segments[i], uprights);
      seconds.project += since(start);
      counts.segments += segments[i].size();
      lists.push_back({segments[i], Role::drawn_occluder});
    }
    const auto start = Clock::now();
    const std::vector<ExactClip> clipped = exact_clip(lists);
    seconds.clip += since(start);
    for (std::size_t i = 0; i < clipped.size(); ++i) {
      counts.largest_horizon =
          std::max<std::uint64_t>(counts.largest_horizon, clipped[i].least_horizon);
      for (LineObserver* observer : observers)
        observer->see(SeenProfile{
            sector, {-kInfinity, kInfinity}, profiles[i], segments[i], clipped[i].visible});
    }
  }
  return out;
}

// Keeps the visible stretches of each profile, in mm on the page along it. REQUIRES that the
// placed view outlives the record. Memory: 16 bytes a stretch.
class VisibleRecord : public LineObserver {
public:
  explicit VisibleRecord(const PlacedView& scene) : scene_(scene) {}

  void see(const SeenProfile& seen) override;
  void see(const SeenLines&) override {}

  using Stretches = std::vector<std::pair<double, double>>;
  const std::vector<Stretches>& profiles() const { return profiles_; }

private:
  const PlacedView& scene_;
  std::vector<Stretches> profiles_;
};

void VisibleRecord::see(const SeenProfile& seen) {
  const auto& [sector, clipped, profile, segments, visible] = seen;
  Stretches& stretches = profiles_.emplace_back();
  const auto at = [&](std::uint32_t vertex) {
    return ProfilePoint{profile.u_m[vertex], profile.depth_m, profile.z_m[vertex]};
  };
  double start_mm = 0; // the same in every run, whatever segments arithmetic has lost
  auto piece = visible.begin();
  for (std::uint32_t vertex = 0; vertex + 1 < profile.size(); ++vertex) {
    if (profile.after[vertex] == Span::gap) continue;
    const auto line = LineOnPage::of({at(vertex), at(vertex + 1)}, sector.view, sector.to_page,
                                     scene_.page.inner_mm());
    for (; piece != visible.end() && left_vertex(segments[piece->segment]) <= vertex; ++piece) {
      if (!line || left_vertex(segments[piece->segment]) < vertex) continue;
      const auto mm = [&](double t) {
        return start_mm + std::clamp(line->mm_at(t), 0.0, line->length_mm());
      };
      const double begin = mm(piece->t_begin), end = mm(piece->t_end);
      if (!stretches.empty() && stretches.back().second >= begin)
        stretches.back().second = std::max(stretches.back().second, end);
      else
        stretches.emplace_back(begin, end);
    }
    if (line) start_mm += line->length_mm();
  }
}

// The longest stretch that is visible in one run of a view and hidden in the other: 0 where the two
// agree, else how far an end has moved, or what was lost or gained.
double longest_difference_mm(const VisibleRecord& a, const VisibleRecord& b) {
  double longest = 0;
  for (std::size_t i = 0; i < std::min(a.profiles().size(), b.profiles().size()); ++i) {
    // Ends in order: between two of them either run is visible or hidden throughout.
    std::vector<std::pair<double, bool>> ends; // place, of `a`
    for (const auto& [begin, end] : a.profiles()[i]) {
      ends.emplace_back(begin, true);
      ends.emplace_back(end, true);
    }
    for (const auto& [begin, end] : b.profiles()[i]) {
      ends.emplace_back(begin, false);
      ends.emplace_back(end, false);
    }
    std::sort(ends.begin(), ends.end());
    bool in_a = false, in_b = false;
    for (std::size_t k = 0; k < ends.size(); ++k) {
      if (in_a != in_b) longest = std::max(longest, ends[k].first - ends[k - 1].first);
      bool& in = ends[k].second ? in_a : in_b;
      in = !in;
    }
  }
  return longest;
}

double distance(Vec2 p, Vec2 a, Vec2 b) {
  const Vec2 along = b - a, to = p - a;
  const double square = dot(along, along);
  const double t = square > 0 ? std::clamp(dot(to, along) / square, 0.0, 1.0) : 0;
  return length(to - t * along);
}

// The points that were kept are points of the whole stroke, in order. Of each stretch between two
// of them, the whole stroke's point farthest from the straight line is the Hausdorff distance: the
// line has no point farther from the stretch, which goes from one of its ends to the other.
// None where the strokes aren't the same line.
std::optional<double> distance(std::span<const Vec2> kept, std::span<const Vec2> whole) {
  if (!(kept.front() == whole.front()) || !(kept.back() == whole.back())) return std::nullopt;
  double largest = 0;
  std::size_t at = 0;
  for (std::size_t i = 1; i < kept.size(); ++i) {
    double stretch = 0;
    for (++at; at < whole.size() && !(whole[at] == kept[i]); ++at)
      stretch = std::max(stretch, distance(whole[at], kept[i - 1], kept[i]));
    if (at == whole.size()) return std::nullopt;
    largest = std::max(largest, stretch);
  }
  return largest;
}

// How far a drawing's lines are from those of the same drawing with all its points. REQUIRES that
// `simplified` and `whole` were drawn with the same settings but for how far they are
// simplified. Cost O(points).
SimplifiedDistance simplified_distance(const Drawing& simplified, const Drawing& whole) {
  SimplifiedDistance out;
  for (std::size_t l = 0; l < simplified.layers.size(); ++l) {
    const Layer &few = simplified.layers[l], &all = whole.layers[l];
    std::size_t next = 0; // in the same order; rounding may have dropped some of either
    for (const Stroke& stroke : few.strokes) {
      std::optional<double> found;
      for (std::size_t i = next; i < all.strokes.size() && !found; ++i) {
        if (all.strokes[i].profile != stroke.profile) continue;
        found = distance(few.points(stroke), all.points(all.strokes[i]));
        if (found) next = i + 1;
      }
      ++(found ? out.strokes : out.unmatched);
      if (found) out.largest_mm = std::max(out.largest_mm, *found);
    }
  }
  constexpr double kRounding_mm = 0.5 * std::numbers::sqrt2 * kPageStep_mm;
  out.largest_mm = std::max(0.0, out.largest_mm - kRounding_mm);
  return out;
}

} // namespace

void measure_row(AccuracyRow& row, const AccuracySpec& spec, const MeasuredTerrain& measured,
                 const MapSpec& map) {
  TerrainOfView of_view(measured.whole, map.view);
  const TerrainData& full = of_view.without_level();
  const MapSpec drawn = spec_of(row, map, full);
  std::optional<TerrainData> overview;
  if (row.settings.overview)
    overview = overview_of(measured, *row.settings.overview, full, drawn.view);
  const std::optional<LevelOfDetail> level = choose_level(of_view, drawn, nullptr);
  const TerrainData& terrain = overview ? *overview : *of_view;
  const Surface* full_heights = overview || level ? &full.surface : nullptr;
  const PlacedView scene = overview ? placed_view(terrain, drawn) : placed_view(of_view, drawn);
  row.profile_count = scene.depths_m.size();
  row.promise = promise_of(row.settings, error_budget(terrain, scene, drawn, level));

  const bool exact = row.settings.arithmetic == Arithmetic::exact;
  const auto run = [&](const std::vector<LineObserver*>& observers) {
    if (exact) return draw_exactly(terrain, scene, observers);
    const Instruments instruments{.observers = observers,
                                  .collapse = row.settings.collapse,
                                  .single_precision =
                                      row.settings.arithmetic == Arithmetic::float32,
                                  .beyond_page = true};
    return draw_map(
        terrain, scene, drawn, [](double) {}, instruments);
  };

  // Lengths don't depend on what is hidden, so double precision measures those of any row.
  MapSpec unsimplified = drawn;
  unsimplified.style.simplify_mm = 0;
  InkMeter lengths(terrain.surface, scene, drawn, kNever, full_heights);
  const Map unthinned = draw_map(terrain, scene, unsimplified, [](double) {},
                                 {.observers = {&lengths}, .beyond_page = true});
  check_not_empty(unthinned, drawn.view);

  // Profiles get the points that were asked for, whether other lines are drawn too or not: rows
  // with the same profiles are asked of the same points.
  const double stride_mm = lengths.profiles().length_mm / spec.probes;
  InkMeter ink(terrain.surface, scene, drawn, stride_mm, full_heights);
  const auto ends = static_cast<std::uint64_t>(spec.probes / kProbesAnEnd);
  EndMeter end_meter(terrain.surface, scene, drawn,
                     {ends / 2 / scene.depths_m.size() + 1, ends / 2 + 1});
  VisibleRecord visible(scene);
  std::vector<LineObserver*> observers{&ink};
  if (!full_heights) observers.push_back(&end_meter);
  if (row.group == "arithmetic") observers.push_back(&visible);
  const Map probed = run(observers);

  row.counts = probed.facts.counts;
  row.profiles = ink.profiles();
  row.lines = ink.lines();
  row.ends = end_meter.ends();
  if (full_heights) row.detail_mm = ink.farthest_mm();
  if (exact) {
    row.seconds = probed.facts.seconds; // too slow to be repeated
  } else {
    row.simplified = simplified_distance(probed.drawing, unthinned.drawing);
    for (int i = 0; i < spec.repeats; ++i) keep_least(row.seconds, run({}).facts.seconds);
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
