// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/sweep_sector.hpp"

#include "cli/check.hpp"
#include "cli/profile_strokes.hpp"
#include "cli/scene_lines.hpp"
#include "cli/stopwatch.hpp"
#include "cli/tie_tolerance.hpp"
#include "horizon/clip.hpp"
#include "horizon/upright.hpp"
#include "profiles/cut_surface.hpp"
#include "profiles/project_profile.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

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

// Where the near plane cuts the terrain, a section begins: the cut hides.
void raise_near_cut(const SurfaceCutter& cutter, const View& view, const Instruments& instruments,
                    Horizon& horizon, ClipWorkspace& workspace) {
  Profile cut;
  std::vector<Segment> segments, uprights;
  cutter.cut(view.near_m, cut);
  constexpr std::uint32_t kNearCut = 0x7fffffff; // no profile has this number
  project_profile(cut, kNearCut, view, segments, uprights);
  clip(segments, horizon, {Role::occluder, {}, instruments.collapse}, workspace);
  if (instruments.occluders)
    for (const Segment& s : segments) instruments.occluders->push_back({s.x0, s.x1, s, false});
}

} // namespace

SectorLines sweep_sector(const Terrain& terrain, const Scene& scene, const Sector& sector,
                         const std::vector<SweptLine>& lines, const RenderSettings& settings,
                         const Instruments& instruments, StrokeBuilder* profiles,
                         const SweepCounts& found, const std::function<void()>& profile_done) {
  auto& [counts, seconds, check_counts] = found;
  Stopwatch watch;
  const View& view = sector.view;
  const bool surface = settings.occluder == Occluder::surface;
  const double from_m =
      view.is_perspective() ? view.near_m : -std::numeric_limits<double>::infinity();
  const SurfaceCutter cutter(terrain.surface, view, scene.level.triangles, scene.border);
  const TieTolerance tolerance = tie_tolerance(sector, settings.visibility_tolerance_mm);
  LineSweep sweep(terrain.surface, sector, lines, from_m, tolerance);
  if (instruments.occluders) sweep.record(*instruments.occluders);
  watch.mark(seconds.facing);

  const ClipOptions clip_options{surface ? Role::compared : Role::drawn_occluder, tolerance,
                                 instruments.collapse};
  // Half of the points of a check are asked of profiles, half of the other lines.
  std::optional<Check> check;
  if (settings.check > 0) check.emplace(terrain.surface, view, tolerance);
  const std::uint64_t asked_a_profile = settings.check / 2 / scene.depths_m.size() + 1;
  std::optional<ProfileStrokes> strokes;
  if (profiles) strokes.emplace(scene.view, sector, settings.flat == FlatGround::draw, *profiles);
  Horizon horizon = initial_horizon();
  Profile profile;
  std::vector<Segment> segments, uprights;
  ClipWorkspace workspace;
  if (surface && view.is_perspective())
    raise_near_cut(cutter, view, instruments, horizon, workspace);

  // Slabs are about a cell thick, so that few lines meet in one; but slivers that a cut has left
  // don't make millions of them.
  constexpr double kMostSlabs = 1e5;
  double plane = std::max(sector.nearest_m, from_m);
  const double thickness = std::max(scene.cell_m, (sector.farthest_m - plane) / kMostSlabs);
  const auto take_slabs = [&](double to_m) {
    const double count = surface ? std::ceil((to_m - plane) / thickness) : 1;
    for (int i = 1; i < count; ++i)
      sweep.take_slab(plane + (to_m - plane) * (i / count), horizon, workspace,
                      instruments.collapse);
    sweep.take_slab(to_m, horizon, workspace, instruments.collapse);
    plane = to_m;
  };
  for (const auto& [depth_m, number] : sector.profiles) {
    take_slabs(depth_m);
    watch.mark(seconds.clip);
    cutter.cut(depth_m, profile);
    watch.mark(seconds.cut);
    project_profile(profile, static_cast<std::uint32_t>(number), view, segments, uprights);
    if (instruments.single_precision) round_to_float(segments);
    watch.mark(seconds.project);
    const std::vector<Piece> on_walls = visible_uprights(
        uprights, horizon, beside_walls(uprights, view, depth_m, sweep.rounding_m()));
    clip(segments, horizon, clip_options, workspace);
    if (!uprights.empty()) insert_uprights(uprights, on_walls, segments, workspace.visible);
    watch.mark(seconds.clip);
    if (strokes) strokes->add(profile, number, segments, workspace.visible);
    watch.mark(seconds.layout);
    if (check) check->ask(profile, segments, workspace.visible, asked_a_profile);
    if (instruments.observer) {
      instruments.observer->see(sector, profile, segments, workspace.visible);
      instruments.observer->see_horizon(sector, horizon);
    }
    watch.mark(seconds.check);

    counts.cut_vertices += profile.size();
    counts.segments += segments.size();
    counts.largest_horizon = std::max<std::uint64_t>(counts.largest_horizon, horizon.size());
    profile_done();
  }
  if (plane < sector.farthest_m) take_slabs(sector.farthest_m);
  sweep.take_slab(std::numeric_limits<double>::infinity(), horizon, workspace,
                  instruments.collapse);
  watch.mark(seconds.clip);

  sweep.finish();
  SectorLines out;
  out.skyline = sweep.skyline(horizon);
  out.visible = without(sweep.visible_parts(), out.skyline);
  out.folded = folds(sweep, out.visible, terrain.surface, view, settings.silhouette_jump,
                     sector.farthest_m - sector.nearest_m);
  out.visible = without(out.visible, out.folded);
  watch.mark(seconds.layout);
  if (instruments.observer) instruments.observer->see(sector, sweep, sweep.visible_parts());
  if (check) {
    check->ask(sweep, sweep.visible_parts(), settings.check / 2 / scene.sectors.size());
    check_counts = check_counts ? *check_counts + check->counts() : check->counts();
  }
  watch.mark(seconds.check);
  counts.ties += workspace.ties;
  counts.pieces_before_collapse += workspace.pieces_uncollapsed;
  counts.pieces_after_collapse += workspace.pieces_collapsed;
  return out;
}

} // namespace orograph
