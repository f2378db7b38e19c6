// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/stages/front_to_back.hpp"

#include "cli/strips.hpp"
#include "horizon/blocked_horizon.hpp"
#include "horizon/horizon_pieces.hpp"

#include <algorithm>
#include <deque>
#include <limits>
#include <utility>

namespace orograph {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct StripInWork {
  StripInWork(const SectorInWork& work, const Strip& strip, std::vector<std::uint32_t> which)
      : range(strip.range), lines(work.terrain.surface, work.sector, work.lines, std::move(which),
                                  strip.range, work.from_m, work.tolerance),
        horizon(strip.core.begin, strip.core.end, strip.blocks, lines.looked_at().begin,
                lines.looked_at().end),
        planes(work) {}

  void take_slabs(double to_m) {
    planes.take_to(to_m, [&](double plane_m) { take_slab(plane_m); });
  }
  void take_slab(double to_m) {
    lines.take_slab(to_m, horizon, [](std::vector<HorizonPiece>& occluders, BlockedHorizon& all) {
      std::sort(occluders.begin(), occluders.end(), is_raised_before);
      for (const HorizonPiece& occluder : occluders) all.raise(occluder);
    });
  }

  XRange range;
  LineSweep lines;
  BlockedHorizon horizon;
  SlabPlanes planes;
  ProfileClipCounts counts;
};

// Not movable: a LineSweep is referred to from within.
std::deque<StripInWork> strips_of(const SectorInWork& work) {
  const std::vector<Strip> plan =
      plan_strips(work.scene, work.sector, work.range, work.vertices_a_strip);
  std::vector<XRange> ranges;
  for (const Strip& strip : plan) ranges.push_back(strip.range);
  auto which = lines_by_range(work.terrain.surface, work.sector, work.lines, ranges, work.from_m);
  std::deque<StripInWork> strips;
  for (std::size_t i = 0; i < plan.size(); ++i)
    strips.emplace_back(work, plan[i], std::move(which[i]));
  return strips;
}

} // namespace

SweepFound sweep_front_to_back(const StagedView& view, const std::vector<SweptLine>& lines,
                               SweepMeters& meters,
                               const std::function<void(const ProfileInWork&)>& profile_done) {
  const SectorInWork work = view.work_with(lines);
  const Sector& sector = view.sector();
  std::deque<StripInWork> strips = strips_of(work);
  SweepFound found;
  ProfileInWork profile;
  profile.by_strip.resize(strips.size());
  for (const PlannedProfile& planned : sector.profiles) {
    profile.planned = planned;
    view.cutter.cut(planned.depth_m, profile.profile);
    project_profile(profile.profile, static_cast<std::uint32_t>(planned.number), sector.view,
                    profile.projected, profile.uprights);
    meters.lines.measure([&] {
      for (StripInWork& strip : strips) strip.take_slabs(planned.depth_m);
    });
    meters.profiles.measure([&] {
      for (std::size_t i = 0; i < strips.size(); ++i) {
        profile.by_strip[i].clear();
        clip_profile(profile.projected, strips[i].range, strips[i].horizon, work.tolerance,
                     profile.by_strip[i], strips[i].counts);
      }
    });
    found.cut_vertices += profile.profile.size();
    profile_done(profile);
  }
  meters.lines.measure([&] {
    for (StripInWork& strip : strips) {
      if (strip.planes.last_m() < sector.farthest_m) strip.take_slabs(sector.farthest_m);
      strip.take_slab(kInfinity);
    }
  });
  for (const StripInWork& strip : strips) {
    const std::vector<LinePart>& parts = strip.lines.visible_parts();
    found.visible.insert(found.visible.end(), parts.begin(), parts.end());
  }
  return found;
}

} // namespace orograph
