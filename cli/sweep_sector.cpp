// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/sweep_sector.hpp"

#include "cli/check.hpp"
#include "cli/profile_batch.hpp"
#include "cli/profile_strokes.hpp"
#include "cli/scene_lines.hpp"
#include "cli/stopwatch.hpp"
#include "cli/strips.hpp"
#include "cli/sweep_strips.hpp"
#include "cli/tie_tolerance.hpp"
#include "horizon/clip.hpp"
#include "horizon/upright.hpp"
#include "profiles/cut_surface.hpp"
#include "profiles/project_profile.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

namespace orograph {
namespace {

// What is that close in X to a profile's way along a wall counts as being at it.
double beside_walls(const std::vector<Segment>& uprights, const View& view, double depth_m,
                    double rounding_m) {
  if (!view.is_perspective()) return rounding_m;
  double greatest_x = 0;
  for (const Segment& s : uprights) greatest_x = std::max(greatest_x, std::abs(s.x0));
  return rounding_m * (1 + greatest_x) / depth_m;
}

// One slab after another with the horizon in one list, profile after profile: where profiles hide,
// and for those who watch the horizon.
SweptSector sweep_in_list(const SectorInWork& work, bool surface, const Instruments& instruments,
                          const LayOut& lay_out, const Show& show, CountsReport& counts,
                          SecondsReport& seconds) {
  Stopwatch watch;
  const Sector& sector = work.sector;
  const View& view = sector.view;
  std::vector<std::uint32_t> all(work.lines.size());
  std::iota(all.begin(), all.end(), 0U);
  LineSweep sweep(work.terrain.surface, sector, work.lines, std::move(all), work.range, work.from_m,
                  work.tolerance);
  if (instruments.occluders) sweep.record(*instruments.occluders);
  const ClipOptions options{surface ? Role::compared : Role::drawn_occluder, work.tolerance,
                            instruments.collapse};
  Horizon horizon = initial_horizon();
  ClipWorkspace workspace;
  std::vector<Segment> segments, uprights;
  ProfileInWork profile;
  profile.by_strip.resize(1);
  if (surface && view.is_perspective()) {
    // Where the near plane cuts the terrain, a section begins: the cut hides.
    work.cutter.cut(view.near_m, profile.profile);
    project_profile(profile.profile, work.near_cut, view, segments, uprights);
    clip(segments, horizon, {Role::occluder, {}, instruments.collapse}, workspace);
    if (instruments.occluders)
      for (const Segment& s : segments) instruments.occluders->push_back({s.x0, s.x1, s, false});
  }
  watch.mark(seconds.facing);

  double plane = std::max(sector.nearest_m, work.from_m);
  const double thickness = slab_thickness_m(work, plane);
  const auto take_slab = [&](double to_m) {
    sweep.take_slab(to_m, horizon, [&](std::vector<HorizonPiece>& occluders, Horizon& raised) {
      raise(occluders, raised, workspace, instruments.collapse);
    });
  };
  const auto take_slabs = [&](double to_m) {
    const double count = surface ? std::ceil((to_m - plane) / thickness) : 1;
    for (int i = 1; i < count; ++i) take_slab(plane + (to_m - plane) * (i / count));
    take_slab(to_m);
    plane = to_m;
  };
  for (const PlannedProfile& planned : sector.profiles) {
    const double depth_m = planned.depth_m;
    profile.planned = planned;
    take_slabs(depth_m);
    watch.mark(seconds.clip);
    work.cutter.cut(depth_m, profile.profile);
    watch.mark(seconds.cut);
    const auto number = static_cast<std::uint32_t>(planned.number);
    project_profile(profile.profile, number, view, profile.projected, profile.uprights);
    project_profile(profile.profile, number, view, segments, uprights);
    if (instruments.single_precision) round_to_float(segments);
    watch.mark(seconds.project);
    auto& visible = profile.by_strip.front();
    visible.clear();
    for (const Piece& piece : visible_uprights(
             uprights, horizon, beside_walls(uprights, view, depth_m, sweep.rounding_m()))) {
      const std::uint32_t vertex = left_vertex(uprights[piece.segment]);
      visible.push_back({vertex, vertex, piece.t_begin, piece.t_end});
    }
    clip(segments, horizon, options, workspace);
    for (const Piece& piece : workspace.visible) {
      const std::uint32_t vertex = left_vertex(segments[piece.segment]);
      visible.push_back({vertex, vertex, piece.t_begin, piece.t_end});
    }
    watch.mark(seconds.clip);
    join_strips(profile);
    lay_out(profile);
    watch.mark(seconds.layout);
    show(profile);
    if (instruments.observer) instruments.observer->see_horizon(sector, horizon);
    counts.cut_vertices += profile.profile.size();
    counts.segments += segments.size();
    counts.largest_horizon = std::max<std::uint64_t>(counts.largest_horizon, horizon.size());
    watch = {};
  }
  if (plane < sector.farthest_m) take_slabs(sector.farthest_m);
  take_slab(std::numeric_limits<double>::infinity());
  watch.mark(seconds.clip);
  counts.ties += workspace.ties;
  counts.pieces_before_collapse += workspace.pieces_uncollapsed;
  counts.pieces_after_collapse += workspace.pieces_collapsed;
  SweptSector out{sweep.visible_parts(), sweep.skyline(horizon)};
  join(out.visible);
  out.skyline = shared(out.skyline, out.visible);
  watch.mark(seconds.layout);
  return out;
}

} // namespace

SectorLines sweep_sector(const Terrain& terrain, const Scene& scene, const Sector& sector,
                         const std::vector<SweptLine>& lines, const RenderSettings& settings,
                         const Instruments& instruments, ProfileLayer* profiles,
                         const SweepCounts& found, const std::function<void()>& profile_done) {
  auto& [counts, seconds, check_counts] = found;
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Stopwatch watch;
  const View& view = sector.view;
  const bool surface = settings.occluder == Occluder::surface;
  const SurfaceCutter cutter(terrain.surface, view, scene.level.triangles, scene.border);
  const TieTolerance tolerance = tie_tolerance(sector, settings.visibility_tolerance_mm);
  // Half of the points of a check are asked of profiles, half of the other lines.
  std::optional<Check> check;
  if (settings.check > 0) check.emplace(terrain.surface, view, tolerance);
  const std::uint64_t asked_a_profile = settings.check / 2 / scene.depths_m.size() + 1;
  const bool in_list = !surface || instruments.needs_list();
  const bool watched = check || instruments.observer;
  constexpr std::uint32_t kNearCut = 0x7fffffff; // no profile has this number
  const SectorInWork work{terrain,
                          scene,
                          sector,
                          lines,
                          cutter,
                          tolerance,
                          view.is_perspective() ? view.near_m : -kInfinity,
                          in_list || instruments.beyond_page ? XRange{-kInfinity, kInfinity}
                                                             : page_range(sector),
                          watched,
                          instruments.vertices_a_strip,
                          kNearCut};
  const LayOut lay_out = [&](ProfileInWork& profile) {
    if (!profiles) return;
    profile.strokes.clear();
    StrokeBuilder builder(profiles->settings, profile.strokes);
    ProfileStrokes(scene.view, sector, settings.flat == FlatGround::draw, builder)
        .add(profile.profile, profile.planned.number, profile.visible);
    profile.left_out_mm = builder.left_out_mm();
  };
  const Show show = [&](ProfileInWork& profile) {
    Stopwatch own;
    if (profiles) {
      append(profiles->layer, profile.strokes);
      profiles->left_out_mm += profile.left_out_mm;
    }
    own.mark(seconds.layout);
    if (check) {
      const auto& [segments, visible] = pieces_of(profile, view, work.range);
      check->ask(profile.profile, segments, visible, asked_a_profile);
    }
    if (instruments.observer) {
      const auto& [segments, visible] = pieces_of(profile, view, {-kInfinity, kInfinity});
      instruments.observer->see(sector, profile.profile, segments, visible);
    }
    own.mark(seconds.check);
    profile_done();
  };
  watch.mark(seconds.facing);
  const SweptSector swept =
      in_list ? sweep_in_list(work, surface, instruments, lay_out, show, counts, seconds)
              : sweep_strips(work, lay_out, show, counts, seconds);

  watch = {};
  const LineSweep asked(terrain.surface, sector, lines, {}, work.range, work.from_m, tolerance);
  SectorLines out;
  out.skyline = swept.skyline;
  out.visible = without(swept.visible, out.skyline);
  out.folded = folds(asked, out.visible, terrain.surface, view, settings.silhouette_jump,
                     sector.farthest_m - sector.nearest_m);
  out.visible = without(out.visible, out.folded);
  watch.mark(seconds.layout);
  if (instruments.observer) instruments.observer->see(sector, asked, swept.visible);
  if (check) {
    check->ask(asked, swept.visible, work.range, settings.check / 2 / scene.sectors.size());
    check_counts = check_counts ? *check_counts + check->counts() : check->counts();
  }
  watch.mark(seconds.check);
  return out;
}

} // namespace orograph
