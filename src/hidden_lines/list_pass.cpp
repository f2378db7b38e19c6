// SPDX-License-Identifier: GPL-3.0-or-later
#include "hidden_lines/list_pass.hpp"

#include "geometry/on_all_cores.hpp"
#include "horizon/clip.hpp"

#include <limits>
#include <span>

#include "hidden_lines/stopwatch.hpp"

namespace orograph {

SectorParts list_pass(const SectorInWork& work, bool surface, const Instruments& instruments,
                      const LayOut& lay_out, const Show& show, Counts& counts,
                      StageSeconds& seconds) {
  Stopwatch watch;
  const Sector& sector = work.sector;
  const View& view = sector.view;
  const auto which = lines_by_range(work.terrain.surface, sector, work.lines,
                                    std::span(&work.range, 1), work.from_m);
  LinePass lines(work.terrain.surface, sector, work.lines, which.front(), work.range, work.from_m,
                 work.tolerance);
  if (instruments.occluders) lines.record(*instruments.occluders);
  const ClipOptions options{surface ? Role::compared : Role::drawn_occluder, work.tolerance,
                            instruments.collapse};
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
    add_visible_uprights(profile, view, work.range, horizon, lines.rounding_m(), visible);
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
  take_slab(std::numeric_limits<double>::infinity());
  watch.mark(seconds.clip);
  counts.ties += workspace.ties;
  counts.pieces_before_collapse += workspace.pieces_uncollapsed;
  counts.pieces_after_collapse += workspace.pieces_collapsed;
  SectorParts out{lines.visible_parts(), lines.skyline(horizon)};
  join(out.visible);
  out.skyline = shared(out.skyline, out.visible);
  watch.mark(seconds.layout);
  return out;
}

} // namespace orograph
