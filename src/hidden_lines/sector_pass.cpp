// SPDX-License-Identifier: GPL-3.0-or-later
#include "hidden_lines/sector_pass.hpp"

#include "draw/round_drawing.hpp"
#include "profiles/cut_surface.hpp"

#include <limits>
#include <optional>

#include "hidden_lines/behind_solids.hpp"
#include "hidden_lines/list_pass.hpp"
#include "hidden_lines/profile_strokes.hpp"
#include "hidden_lines/stopwatch.hpp"
#include "hidden_lines/strips.hpp"
#include "hidden_lines/strips_pass.hpp"
#include "hidden_lines/surface_lines.hpp"
#include "hidden_lines/tie_tolerance.hpp"

namespace orograph {

SectorLines solids_alone(const PlacedView& placed, const Sector& sector) {
  const SolidsInView solids(placed.solids, sector.view);
  SectorLines out;
  out.solids = seen_edges(solids, std::vector<GroundShadows>(placed.solids.size()));
  return out;
}

SectorLines sector_pass(const TerrainData& terrain, const PlacedView& placed, const Sector& sector,
                        const std::vector<EdgeLine>& lines, const SeenGround* ground,
                        const Style& style, const Instruments& instruments, ProfileLayer* profiles,
                        const PassCounts& found, const std::function<void()>& profile_done) {
  auto& [counts, seconds] = found;
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Stopwatch watch;
  const View& view = sector.view;
  const bool surface = style.occluder == Occluder::surface;
  const SurfaceCutter cutter(terrain.surface, view, placed.level.triangles, placed.border);
  const TieTolerance tolerance = tie_tolerance(sector, style.visibility_tolerance_mm);
  const bool in_list = !surface || instruments.needs_list();
  const bool watched = !instruments.observers.empty();
  const SectorInWork work{terrain,
                          placed,
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
  if (!placed.solids.empty()) solids.emplace(placed.solids, view);
  const LayOut lay_out = [&](ProfileInWork& profile) {
    if (!profiles) return;
    profile.strokes.clear();
    StrokeBuilder builder(profiles->settings, profile.strokes);
    ProfileStrokes strokes(placed.view, sector, style.flat == FlatGround::draw, builder);
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
    if (watched) {
      const auto& [segments, visible] = pieces_of(profile, view);
      for (LineObserver* observer : instruments.observers)
        observer->see(SeenProfile{sector, work.range, profile.profile, segments, visible});
    }
    own.mark(seconds.check);
    profile_done();
  };
  watch.mark(seconds.facing);
  const SectorParts found_parts =
      in_list ? list_pass(work, surface, instruments, lay_out, show, counts, seconds)
              : strips_pass(work, lay_out, show, counts, seconds);

  watch = {};
  const LinePass every_line(terrain.surface, sector, lines, {}, work.range, work.from_m, tolerance);
  SectorLines out;
  out.skyline = found_parts.skyline;
  out.visible = without(found_parts.visible, out.skyline);
  out.folded = folds(every_line, out.visible, terrain.surface, view, style.silhouette_jump,
                     sector.farthest_m - sector.nearest_m);
  out.visible = without(out.visible, out.folded);
  watch.mark(seconds.layout);
  if (solids) {
    for (std::vector<LinePart>* parts : {&out.visible, &out.skyline, &out.folded})
      *parts = not_behind(*solids, every_line, *parts);
    out.solids = seen_edges(*solids, ground_shadows(terrain, placed, sector, lines,
                                                    found_parts.visible, near_cut(work), *solids));
    watch.mark(seconds.clip);
  }
  for (LineObserver* observer : instruments.observers)
    observer->see(SeenLines{sector, work.range, every_line, found_parts.visible});
  watch.mark(seconds.check);
  return out;
}

} // namespace orograph
