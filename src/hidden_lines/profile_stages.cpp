// SPDX-License-Identifier: GPL-3.0-or-later
#include "hidden_lines/profile_stages.hpp"

#include "hidden_lines/instruments.hpp"

#include <algorithm>
#include <numeric>

namespace orograph {

void TimedProfile::add_to(StageSeconds& seconds) const {
  seconds.cut += cut_s;
  seconds.project += project_s;
  seconds.layout += layout_s;
}

ProfileStages::ProfileStages(const SectorInWork& work, const LayOut& lay_out, std::size_t strips)
    : work_(work), lay_out_(lay_out), strips_(strips) {
  // On the ellipsoid profiles are cut whole.
  if (!work.ground) return;
  const Grid& grid = std::get<Grid>(work.terrain.surface);
  if (!grid.is_on_earth()) over_blocks_.emplace(grid, work.sector.view);
}

namespace {

// What of rising parts has lines. Those that would be too near one another for a cutter are one.
std::vector<URange> parts_in_runs(const std::vector<URange>& parts, const PlannedProfile& planned,
                                  const View& view, double cell_m) {
  constexpr double kCellsApart = 16;
  std::vector<URange> out;
  auto part = parts.begin();
  for (const ToneRun& run : *planned.runs) {
    const URange range = u_range(view, planned.depth_m, {run.x_begin, run.x_end});
    while (part != parts.end() && part->high_m <= range.low_m) ++part;
    for (auto next = part; next != parts.end() && next->low_m < range.high_m; ++next) {
      const URange both{std::max(next->low_m, range.low_m), std::min(next->high_m, range.high_m)};
      if (!out.empty() && both.low_m - out.back().high_m <= kCellsApart * cell_m)
        out.back().high_m = std::max(out.back().high_m, both.high_m);
      else
        out.push_back(both);
    }
  }
  return out;
}

} // namespace

void ProfileStages::cut(TimedProfile& timed, std::size_t index) const {
  Stopwatch watch;
  ProfileInWork& profile = timed.profile;
  const View& view = work_.sector.view;
  profile.planned = work_.sector.profiles[index];
  profile.index = index;
  profile.by_strip.resize(strips_);
  for (std::vector<VisibleRun>& runs : profile.by_strip) runs.clear();
  if (work_.sheet) profile.underside_by_strip.resize(strips_);
  for (std::vector<VisibleRun>& runs : profile.underside_by_strip) runs.clear();
  profile.horizon_sizes.assign(strips_, 0);
  if (work_.passes_over_profiles) return;
  const double depth_m = profile.planned.depth_m;
  const URange asked = work_.whole_profiles ? URange{} : u_range(view, depth_m, work_.range);
  if (over_blocks_)
    over_blocks_->seen_parts(depth_m, asked, *work_.ground, timed.parts);
  else
    timed.parts.assign(1, asked);
  if (profile.planned.runs && !work_.whole_profiles && !work_.hidden_profiles)
    timed.parts = parts_in_runs(timed.parts, profile.planned, view, work_.placed.cell_m);
  work_.cutter.cut(depth_m, timed.parts, profile.profile);
  watch.mark(timed.cut_s);
  project_profile(profile.profile, static_cast<std::uint32_t>(profile.planned.number), view,
                  profile.projected, profile.uprights);
  watch.mark(timed.project_s);
}

void ProfileStages::lay_out(TimedProfile& timed) const {
  Stopwatch watch;
  join_strips(timed.profile);
  lay_out_(timed.profile);
  watch.mark(timed.layout_s);
}

void count(const ProfileInWork& profile, Counts& counts) {
  counts.cut_vertices += profile.profile.size();
  for (const VertexRun& run : profile.projected.runs) counts.segments += run.last - run.first;
  const auto& sizes = profile.horizon_sizes;
  counts.largest_horizon = std::max(counts.largest_horizon,
                                    std::accumulate(sizes.begin(), sizes.end(), std::uint64_t{0}));
}

} // namespace orograph
