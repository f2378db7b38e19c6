// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/sweep_sector.hpp"

#include "cli/check.hpp"
#include "cli/profile_strokes.hpp"
#include "cli/scene_lines.hpp"
#include "cli/solids/behind_solids.hpp"
#include "cli/stopwatch.hpp"
#include "cli/strips.hpp"
#include "cli/sweep_in_list.hpp"
#include "cli/sweep_strips.hpp"
#include "cli/tie_tolerance.hpp"
#include "draw/round_drawing.hpp"
#include "profiles/cut_surface.hpp"

#include <limits>
#include <optional>

namespace orograph {

SectorLines solids_alone(const Scene& scene, const Sector& sector) {
  const SolidsInView solids(scene.solids, sector.view);
  SectorLines out;
  out.solids = seen_edges(solids, std::vector<GroundShadows>(scene.solids.size()));
  return out;
}

SectorLines sweep_sector(const Terrain& terrain, const Scene& scene, const Sector& sector,
                         const std::vector<SweptLine>& lines, const SeenGround* ground,
                         const RenderSettings& settings, const Instruments& instruments,
                         ProfileLayer* profiles, const SweepCounts& found,
                         const std::function<void()>& profile_done) {
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
                          watched ? nullptr : ground,
                          instruments.vertices_a_strip};
  std::optional<SolidsInView> solids;
  if (!scene.solids.empty()) solids.emplace(scene.solids, view);
  const LayOut lay_out = [&](ProfileInWork& profile) {
    if (!profiles) return;
    profile.strokes.clear();
    StrokeBuilder builder(profiles->settings, profile.strokes);
    ProfileStrokes strokes(scene.view, sector, settings.flat == FlatGround::draw, builder);
    if (solids) {
      std::vector<VisibleRun> runs = profile.visible; // which those who watch want as they are
      leave_out_behind(*solids, profile.profile, runs);
      strokes.add(profile.profile, profile.planned.number, runs);
    } else {
      strokes.add(profile.profile, profile.planned.number, profile.visible);
    }
    profile.left_out_mm = builder.left_out_mm();
    profile.dropped_strokes = round_strokes(profile.strokes).empty_strokes;
  };
  const Show show = [&](ProfileInWork& profile) {
    Stopwatch own;
    if (profiles) {
      append(profiles->layer, profile.strokes);
      profiles->left_out_mm += profile.left_out_mm;
      profiles->dropped_strokes += profile.dropped_strokes;
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
  const LineSweep every_line(terrain.surface, sector, lines, {}, work.range, work.from_m,
                             tolerance);
  SectorLines out;
  out.skyline = swept.skyline;
  out.visible = without(swept.visible, out.skyline);
  out.folded = folds(every_line, out.visible, terrain.surface, view, settings.silhouette_jump,
                     sector.farthest_m - sector.nearest_m);
  out.visible = without(out.visible, out.folded);
  watch.mark(seconds.layout);
  if (solids) {
    for (std::vector<LinePart>* parts : {&out.visible, &out.skyline, &out.folded})
      *parts = not_behind(*solids, every_line, *parts);
    out.solids = seen_edges(*solids, ground_shadows(terrain, scene, sector, lines, swept.visible,
                                                    near_cut(work), *solids));
    watch.mark(seconds.clip);
  }
  if (instruments.observer) instruments.observer->see(sector, every_line, swept.visible);
  if (check) {
    check->ask(every_line, swept.visible, work.range, settings.check / 2 / scene.sectors.size());
    check_counts = check_counts ? *check_counts + check->counts() : check->counts();
  }
  watch.mark(seconds.check);
  return out;
}

} // namespace orograph
