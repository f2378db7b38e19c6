// SPDX-License-Identifier: GPL-3.0-or-later
#include "hidden_lines/strip_pass.hpp"

#include "geometry/on_all_cores.hpp"

#include <limits>

namespace orograph {

StripPass::StripPass(const SectorInWork& work, const Strip& strip,
                     std::span<const LineAtDepth> which, std::span<const Segment> near_cut)
    : work_(work), range_(strip.range), lines_(work.terrain.surface, work.sector, work.lines, which,
                                               strip.range, work.from_m, work.tolerance),
      horizon_(strip.core.begin, strip.core.end, strip.blocks, lines_.looked_at().begin,
               lines_.looked_at().end),
      planes_(work) {
  for (const Segment& s : near_cut)
    if (s.x0 <= range_.end && s.x1 >= range_.begin) horizon_.raise({s.x0, s.x1, s, false});
}

void StripPass::take_lines(double to_m) {
  planes_.take_to(to_m, [&](double plane_m) { take_slab(plane_m); });
}

void StripPass::take_profile(const ProfileInWork& profile, std::vector<VisibleRun>& visible) {
  visible.clear();
  clip_profile(profile.projected, range_, horizon_, work_.tolerance, visible, counts_);
  add_visible_uprights(profile, work_.sector.view, range_, horizon_, lines_.rounding_m(), visible);
}

void StripPass::finish() {
  if (planes_.last_m() < work_.sector.farthest_m) take_lines(work_.sector.farthest_m);
  take_slab(std::numeric_limits<double>::infinity());
}

void StripPass::take_slab(double to_m) {
  throw_if_stopped();
  // Of equally high ones the first stands, as in `orograph::raise`.
  lines_.take_slab(to_m, horizon_,
                   [](std::span<const HorizonPiece> occluders, BlockedHorizon& horizon) {
                     for (const HorizonPiece& occluder : occluders) horizon.raise(occluder);
                   });
}

std::vector<std::unique_ptr<StripPass>> strips_of(const SectorInWork& work) {
  const std::vector<Strip> plan =
      plan_strips(work.placed, work.sector, work.range, work.vertices_a_strip);
  std::vector<XRange> ranges;
  for (const Strip& strip : plan) ranges.push_back(strip.range);
  const auto which =
      lines_by_range(work.terrain.surface, work.sector, work.lines, ranges, work.from_m);
  const std::vector<Segment> cut = near_cut(work);
  std::vector<std::unique_ptr<StripPass>> strips(plan.size());
  on_all_cores(plan.size(), [&](std::size_t i) {
    strips[i] = std::make_unique<StripPass>(work, plan[i], which[i], cut);
  });
  return strips;
}

} // namespace orograph
