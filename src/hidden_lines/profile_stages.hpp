// SPDX-License-Identifier: GPL-3.0-or-later
// What is done with a profile before and after it is clipped, and what the strips of a sector have
// found together.
#pragma once

#include "geometry/on_all_cores.hpp"
#include "hidden_lines/instruments.hpp"
#include "hidden_lines/line_pictures.hpp"
#include "hidden_lines/sector_in_work.hpp"
#include "hidden_lines/strips.hpp"
#include "profiles/seen_ground.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <memory>
#include <optional>
#include <vector>

namespace orograph {

/// A profile in work, and the seconds that it took, over all that its memory was used for.
struct TimedProfile {
  ProfileInWork profile;
  std::vector<URange> parts; ///< that are cut
  double cut_s = 0, project_s = 0, layout_s = 0;

  void add_to(StageSeconds& seconds) const;
};

/// Cuts, projects and lays out. Safe from several threads, for different profiles.
class ProfileStages {
public:
  /// REQUIRES that both outlive it. `strips`: of X.
  ProfileStages(const SectorInWork& work, const LayOut& lay_out, std::size_t strips);

  /// Profile number `index` of the sector.
  void cut(TimedProfile& timed, std::size_t index) const;
  /// Of the runs by strip.
  void lay_out(TimedProfile& timed) const;

private:
  const SectorInWork& work_;
  const LayOut& lay_out_;
  std::size_t strips_;
  std::optional<PlaneOverBlocks> over_blocks_;
};

/// Of a profile that was clipped.
void count(const ProfileInWork& profile, Counts& counts);

/// The strips of X of a sector, left to right, made on all cores. `make(i, strip, lines,
/// near_cut)`: strip number i, the lines that reach into it, and what stands in front of
/// everything.
template <class MadeStrip, class Make>
std::vector<std::unique_ptr<MadeStrip>> strips_of(const SectorInWork& work, const Make& make) {
  const std::vector<Strip> plan =
      plan_strips(work.placed, work.sector, work.range, work.vertices_a_strip);
  std::vector<XRange> ranges;
  for (const Strip& strip : plan) ranges.push_back(strip.range);
  const auto lines =
      lines_by_range(work.terrain.surface, work.placed.reach_m, work.on_ground.points, work.sector,
                     work.lines, work.line_numbers, ranges, work.from_m);
  const std::vector<Segment> cut = near_cut(work);
  std::vector<std::unique_ptr<MadeStrip>> strips(plan.size());
  on_all_cores(plan.size(), [&](std::size_t i) { strips[i] = make(i, plan[i], lines[i], cut); });
  return strips;
}

/// What the strips of a sector, left to right, have found of lines.
template <class Strip>
SectorParts parts_of(const SectorInWork& work, const std::vector<std::unique_ptr<Strip>>& strips) {
  SectorParts out;
  std::size_t count = 0;
  for (const auto& strip : strips) count += strip->visible_parts().size();
  out.visible.reserve(count);
  for (const auto& strip : strips) {
    throw_if_stopped();
    std::ranges::copy_if(strip->visible_parts(), std::back_inserter(out.visible),
                         [&](const LinePart& part) { return !work.marks_whole(part); });
    const std::vector<LinePart> skyline = strip->pictures().skyline(strip->horizon().joined());
    out.skyline.insert(out.skyline.end(), skyline.begin(), skyline.end());
  }
  join(out.visible);
  // Most lines on the ground are in two slabs.
  std::erase_if(out.visible, [&](const LinePart& part) { return work.marks_whole(part); });
  join(out.skyline);
  out.skyline = shared(out.skyline, out.visible);
  return out;
}

template <class Strip>
void add_counts(const std::vector<std::unique_ptr<Strip>>& strips, Counts& counts) {
  for (const auto& strip : strips) {
    counts.ties += strip->counts().ties;
    counts.pieces_before_collapse += strip->horizon().pieces_uncollapsed();
    counts.pieces_after_collapse += strip->horizon().pieces_collapsed();
  }
}

/// Makes a pass through a sector, runs it and times its stages.
template <class Pass>
SectorParts run_pass(const SectorInWork& work, const LayOut& lay_out, const Show& show,
                     Counts& counts, StageSeconds& seconds) {
  Stopwatch watch;
  Pass pass(work, lay_out);
  watch.mark(seconds.facing);
  pass.run(show, counts);
  pass.add_to(counts, seconds);
  watch = {};
  SectorParts out = pass.found();
  watch.mark(seconds.layout);
  return out;
}

} // namespace orograph
