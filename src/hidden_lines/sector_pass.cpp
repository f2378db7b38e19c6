// SPDX-License-Identifier: GPL-3.0-or-later
#include "hidden_lines/sector_pass.hpp"

#include "draw/round_drawing.hpp"
#include "geometry/on_all_cores.hpp"
#include "geometry/sort_by_number.hpp"
#include "hidden_lines/folds.hpp"
#include "hidden_lines/ground_lines.hpp"
#include "hidden_lines/instruments.hpp"
#include "hidden_lines/lattice_pass.hpp"
#include "hidden_lines/lines_by_sector.hpp"
#include "hidden_lines/profile_strokes.hpp"
#include "hidden_lines/sheet_pass.hpp"
#include "hidden_lines/solid_lines.hpp"
#include "hidden_lines/strip_pass.hpp"
#include "hidden_lines/strips.hpp"
#include "hidden_lines/surface_lines.hpp"
#include "horizon/clip.hpp"
#include "placing/sector.hpp"
#include "profiles/cut_surface.hpp"
#include "profiles/lattice_order.hpp"

#include <algorithm>
#include <numbers>
#include <optional>
#include <span>
#include <utility>

namespace orograph {
namespace {

// Each coordinate becomes the nearest float. Segments that have no extent in X then are left out.
void round_to_float(std::vector<Segment>& segments) {
  for (Segment& s : segments)
    for (double* coordinate : {&s.x0, &s.y0, &s.x1, &s.y1})
      *coordinate = static_cast<double>(static_cast<float>(*coordinate));
  std::erase_if(segments, [](const Segment& s) { return !(s.x0 < s.x1); });
}

// Room for what all profiles of a sector will add, told by what a share of them has added behind
// the first `before`. By doubling, a profile a row of 4000² rough heights took a fifth more memory
// at its peak, and a fifteenth more time.
template <class Thing>
void make_room(std::vector<Thing>& all, std::size_t before, std::size_t more, double share) {
  constexpr double kLeastShare = 1.0 / 16, kSpare = 1.1;
  if (share < kLeastShare || all.size() + more <= all.capacity()) return;
  const auto added = static_cast<double>(all.size() + more - before);
  all.reserve(before + static_cast<std::size_t>(kSpare * added / share) + 1);
}

// With the horizon in one list, profile after profile: where profiles hide, and for those who watch
// the horizon. `surface`: whether the surface hides, not only the profiles. Of `instruments` it
// minds the horizon's, and shows it to the observers behind each profile.
SectorParts list_pass(const SectorInWork& work, bool surface, const Instruments& instruments,
                      const LayOut& lay_out, const Show& show, Counts& counts,
                      StageSeconds& seconds) {
  Stopwatch watch;
  const Sector& sector = work.sector;
  const View& view = sector.view;
  const auto which =
      lines_by_range(work.terrain.surface, work.placed.reach_m, work.on_ground.points, sector,
                     work.lines, work.line_numbers, std::span(&work.range, 1), work.from_m);
  LinePictures pictures(work.terrain.surface, work.placed.reach_m, work.on_ground.points, sector,
                        work.lines, work.range, work.from_m, work.on_ground.overlays_are_lifted);
  pictures.set_seen_with(work.seen_with);
  LinePass lines(pictures, which.front(), work.tolerance);
  if (instruments.occluders) lines.record(*instruments.occluders);
  const ClipOptions options{surface ? Role::compared : Role::drawn_occluder, work.tolerance,
                            instruments.collapse, work.draws_profiles};
  Horizon horizon = initial_horizon();
  ClipWorkspace workspace;
  std::vector<Segment> segments, uprights;
  ProfileInWork profile;
  profile.by_strip.resize(1);
  if (surface) {
    const std::vector<Segment> cut = near_cut(work);
    if (!cut.empty()) clip(cut, horizon, {Role::occluder, {}, instruments.collapse}, workspace);
    if (instruments.occluders)
      for (const Segment& s : cut) instruments.occluders->push_back({s.x0, s.x1, s, false});
  }
  watch.mark(seconds.facing);

  SlabPlanes planes(work);
  const auto take_slab = [&](double to_m) {
    throw_if_stopped();
    lines.take_slab(to_m, horizon, [&](std::vector<HorizonPiece>& occluders, Horizon& raised) {
      raise(occluders, raised, workspace, instruments.collapse);
    });
  };
  // Where profiles hide, a slab is what lies between two of them.
  const auto take_slabs = [&](double to_m) {
    if (surface)
      planes.take_to(to_m, take_slab);
    else
      take_slab(to_m);
  };
  double last_m = planes.last_m();
  for (const PlannedProfile& planned : sector.profiles) {
    const double depth_m = last_m = planned.depth_m;
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
    add_visible_uprights(profile, view, work.range, horizon, pictures.rounding_m(), visible);
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
    for (LineObserver* observer : instruments.observers) observer->see_horizon(sector, horizon);
    counts.cut_vertices += profile.profile.size();
    counts.segments += segments.size();
    counts.largest_horizon = std::max<std::uint64_t>(counts.largest_horizon, horizon.size());
    watch = {};
  }
  if (last_m < sector.farthest_m) take_slabs(sector.farthest_m);
  take_slab(kInfinity);
  watch.mark(seconds.clip);
  counts.ties += workspace.ties;
  counts.pieces_before_collapse += workspace.pieces_uncollapsed;
  counts.pieces_after_collapse += workspace.pieces_collapsed;
  SectorParts out;
  out.visible = lines.visible_parts();
  out.skyline = pictures.skyline(horizon);
  join(out.visible);
  out.skyline = shared(out.skyline, out.visible);
  watch.mark(seconds.layout);
  return out;
}

} // namespace

SectorLines solids_alone(const PlacedView& placed, const Sector& sector) {
  const SolidsInView solids(placed.solids, sector.view);
  SectorLines out;
  out.solids = seen_edges(solids, nullptr);
  if (sector.frame_mm) keep_in_range(out.solids, placed.solids, sector.view, page_range(sector));
  return out;
}

SectorLines sector_pass(const TerrainData& terrain, const PlacedView& placed, const Sector& sector,
                        const LinesOfView& lines, const SeenGround* ground, const Style& style,
                        const Instruments& instruments, ProfileLayer* profiles,
                        const PassCounts& found, const std::function<void()>& profile_done) {
  auto& [counts, seconds] = found;
  Stopwatch watch;
  const View& view = sector.view;
  const bool surface = style.occluder == Occluder::surface;
  CutterFacts for_cutter = placed.for_cutters;
  for_cutter.both_sides = lines.sheet.has_value();
  const SurfaceCutter cutter(terrain.surface, view, placed.level.triangles, std::move(for_cutter),
                             &placed.extent.box);
  const TieTolerance tolerance = tie_tolerance(sector, style.visibility_tolerance_mm);
  const bool in_list = !surface || instruments.needs_list();
  const bool watched = !instruments.observers.empty();
  const Folds folds(terrain.surface, placed, sector, style.silhouette_jump);
  const Grid* grid = grid_in_order(terrain, style, instruments);
  const EarthStrips* strips = lines.earth_strips ? &*lines.earth_strips : nullptr;
  const SilhouetteMarks* silhouettes =
      grid && lines.silhouettes
          ? lines.silhouettes_by(strips ? strips->are_rows()
                                        : LatticeOrder(*grid, view).rows_are_strips())
          : nullptr;
  std::vector<std::uint8_t> whole(lines.on_ground.lines.size(), 0);
  const auto number = static_cast<std::size_t>(&sector - placed.sectors.data());
  const SectorInWork work{terrain,
                          placed,
                          sector,
                          lines.listed,
                          lines.on_ground,
                          cutter,
                          tolerance,
                          view.is_perspective() ? view.near_m : -kInfinity,
                          asked_range(sector, in_list, instruments),
                          watched && !sector.frame_mm,
                          watched ? nullptr : ground,
                          instruments.vertices_a_strip,
                          silhouettes,
                          &folds,
                          draws_silhouettes(style),
                          lines.on_ground.levels_to_find_m,
                          profiles && profiles->hidden,
                          lines.by_sector.empty() ? nullptr : &lines.by_sector[number],
                          lines.sheet ? &*lines.sheet : nullptr,
                          lines.sheet_parts.empty() ? nullptr : &lines.sheet_parts[number],
                          strips,
                          lines.are_more_overlays || (!profiles && !watched),
                          whole,
                          lines.seen_with,
                          style.asks_for("profiles")};
  std::optional<SolidsInView> solids;
  if (!placed.solids.empty()) solids.emplace(placed.solids, view);
  // A panorama's profiles go on beyond the sector: what is left out, or has a width of its own, and
  // what is rounded, is all of one.
  std::optional<StrokeSettings> settings;
  if (profiles) {
    settings = profiles->settings;
    if (sector.frame_mm) {
      settings->frame_mm = *sector.frame_mm;
      settings->min_stroke_mm = 0;
      settings->keeps_widths = true;
    }
  }
  // Tone is given to what is seen: planes between those planned are nowhere else.
  const auto add_hidden = [&](ProfileInWork& profile, std::span<const VisibleRun> visible) {
    if (profile.planned.level < 0) return;
    StrokeBuilder builder(*settings, profile.hidden_strokes);
    ProfileStrokes(placed.view, sector, style.flat == FlatGround::draw, builder)
        .add(profile.profile, {profile.planned.depth_m, profile.planned.number},
             hidden_runs(profile.profile, visible));
  };
  // With the layer's own pen: light falls on the upper side.
  const auto add_underside = [&](ProfileInWork& profile) {
    std::vector<VisibleRun> runs = profile.underside; // which those who watch want as they are
    if (solids) leave_out_behind(*solids, profile.profile, runs);
    PlannedProfile planned = profile.planned;
    if (planned.runs)
      for (ToneRun& run : *planned.runs) run.width_mm = 0;
    StrokeBuilder builder(*settings, profile.underside_strokes);
    ProfileStrokes(placed.view, sector, true, builder).add(profile.profile, planned, runs);
  };
  const LayOut lay_out = [&](ProfileInWork& profile) {
    if (!profiles) return;
    profile.strokes.clear();
    StrokeBuilder builder(*settings, profile.strokes);
    ProfileStrokes strokes(placed.view, sector, style.flat == FlatGround::draw, builder);
    std::vector<VisibleRun> not_behind_solids;
    if (solids) {
      not_behind_solids = profile.visible; // which those who watch want as they are
      leave_out_behind(*solids, profile.profile, not_behind_solids);
    }
    const std::vector<VisibleRun>& runs = solids ? not_behind_solids : profile.visible;
    strokes.add(profile.profile, profile.planned, runs);
    if (profiles->hidden) {
      profile.hidden_strokes.clear();
      std::vector<VisibleRun> seen(runs.size() + profile.underside.size());
      std::ranges::merge(
          runs, profile.underside, seen.begin(), {},
          [](const VisibleRun& run) { return std::pair(run.first, run.t_begin); },
          [](const VisibleRun& run) { return std::pair(run.first, run.t_begin); });
      add_hidden(profile, seen);
    }
    profile.underside_strokes.clear();
    if (profiles->underside) add_underside(profile);
    profile.left_out_mm = builder.left_out_mm();
    if (!sector.frame_mm) profile.dropped_strokes = round_strokes(profile.strokes).empty_strokes;
  };
  std::size_t shown = 0;
  const std::size_t points_before = profiles ? profiles->layer.page_mm.size() : 0,
                    strokes_before = profiles ? profiles->layer.strokes.size() : 0;
  const Show show = [&](ProfileInWork& profile) {
    Stopwatch own;
    if (profiles) {
      const double share =
          static_cast<double>(++shown) / static_cast<double>(sector.profiles.size());
      make_room(profiles->layer.page_mm, points_before, profile.strokes.page_mm.size(), share);
      make_room(profiles->layer.strokes, strokes_before, profile.strokes.strokes.size(), share);
      append(profiles->layer, profile.strokes);
      if (profiles->hidden) append(*profiles->hidden, profile.hidden_strokes);
      if (profiles->underside) append(*profiles->underside, profile.underside_strokes);
      profiles->left_out_mm += profile.left_out_mm;
      profiles->dropped_strokes += profile.dropped_strokes;
    }
    own.mark(seconds.layout);
    if (watched) {
      const auto& [segments, visible, underside] = pieces_of(profile, view);
      for (LineObserver* observer : instruments.observers) {
        observer->see(SeenProfile{sector, work.range, profile.profile, segments, visible});
        if (work.sheet)
          observer->see_underside(
              SeenProfile{sector, work.range, profile.profile, segments, underside});
      }
    }
    own.mark(seconds.check);
    profile_done();
  };
  watch.mark(seconds.facing);
  const bool in_order = !lines.in_order.empty() && lines.in_order[number];
  SectorParts found_parts =
      work.sheet ? sheet_pass(work, lay_out, show, counts, seconds)
      : in_list  ? list_pass(work, surface, instruments, lay_out, show, counts, seconds)
      : in_order ? lattice_pass(work, lay_out, show, counts, seconds)
                 : strips_pass(work, lay_out, show, counts, seconds);

  watch = {};
  const std::size_t first_on_ground = lines.listed.size() - whole.size();
  if (!whole.empty())
    std::erase_if(found_parts.visible, [&](const LinePart& part) {
      return part.line >= first_on_ground && part.line < lines.listed.size() &&
             whole[part.line - first_on_ground] != 0;
    });
  if (watched || solids || lines.hidden.any() || placed.sectors.size() > 1) { // they are looked at
    found_parts.visible = with_whole(found_parts.visible, first_on_ground, whole);
    whole.clear();
  }
  LinePictures every_line(terrain.surface, placed.reach_m, lines.on_ground.points, sector,
                          lines.listed, work.range, work.from_m);
  every_line.set_found(found_parts.found);
  SectorLines out;
  out.found = std::move(found_parts.found);
  const bool is_one = style.outline == Outline::one;
  if (!outlines_terrain(style,
                        placed.view)) // border stays border, with the ends that it was found with
    std::erase_if(found_parts.skyline, [&](const LinePart& part) {
      return every_line.line(part.line).kind != LineKind::silhouette;
    });
  out.visible = without(found_parts.visible, found_parts.skyline); // which is no fold
  std::vector<LinePart> folded = folds.among(every_line, out.visible);
  out.visible = without(out.visible, folded);
  out.visible.insert(out.visible.end(), found_parts.ridges.begin(), found_parts.ridges.end());
  std::vector<LinePart>& sky = is_one && !style.asks_for("skyline") ? out.visible : out.skyline;
  sky.insert(sky.end(), found_parts.skyline.begin(), found_parts.skyline.end());
  if (is_one)
    join(out.visible);
  else
    sort_by_number(out.visible, [](const LinePart& part) { return part.line; });
  if (lines.hidden.any()) {
    std::vector<LinePart> hidden = hidden_parts(
        every_line, lines.listed.size(), lines.hidden,
        solids ? not_behind(*solids, every_line, found_parts.visible) : found_parts.visible);
    out.hidden = without(hidden, folds.among(every_line, hidden));
  }
  watch.mark(seconds.layout);
  if (solids) {
    for (std::vector<LinePart>* parts : {&out.visible, &out.skyline, &folded})
      *parts = not_behind(*solids, every_line, *parts);
    const std::vector<Segment> cut = near_cut(work);
    const HidingGround hiding{
        terrain, placed,     sector,         lines.listed, found_parts.visible,
        cut,     work.sheet, work.sheet_part};
    out.solids = seen_edges(*solids, &hiding);
    if (sector.frame_mm) keep_in_range(out.solids, placed.solids, view, work.range);
    watch.mark(seconds.clip);
  }
  out.folded_mm = found_parts.folded_mm;
  out.contours = std::move(found_parts.contours);
  out.whole_on_ground = std::move(whole);
  for (const double length_mm : folds.lengths_mm(every_line, folded)) out.folded_mm += length_mm;
  watch.mark(seconds.layout);
  for (LineObserver* observer : instruments.observers)
    if (observer->asks_lines())
      observer->see(
          SeenLines{sector, work.range, every_line, found_parts.visible, work.line_numbers});
  watch.mark(seconds.check);
  return out;
}

} // namespace orograph
