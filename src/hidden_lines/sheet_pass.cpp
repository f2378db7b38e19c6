// SPDX-License-Identifier: GPL-3.0-or-later
#include "hidden_lines/sheet_pass.hpp"

#include "geometry/on_all_cores.hpp"
#include "hidden_lines/instruments.hpp"
#include "hidden_lines/profile_stages.hpp"
#include "hidden_lines/sheet_profiles.hpp"

#include <algorithm>
#include <memory>

namespace orograph {
SectorParts sheet_pass(const SectorInWork& work, const LayOut& lay_out, const Show& show,
                       Counts& counts, StageSeconds& seconds) {
  Stopwatch watch;
  const SheetInWork sheet(work);
  const std::size_t strip_count =
      plan_strips(work.placed, work.sector, work.range, work.vertices_a_strip).size();
  watch.mark(seconds.facing);
  const ProfileStages stages(work, lay_out, strip_count);
  std::vector<TimedProfile> profiles(work.sector.profiles.size());
  on_all_cores(profiles.size(), [&](std::size_t i) {
    thread_local TimedProfile cut; // so that all of them take no more memory than they need
    stages.cut(cut, i);
    profiles[i] = cut;
    cut.cut_s = cut.project_s = 0;
  });
  std::vector<std::unique_ptr<SheetStrip>> strips;
  {
    const std::vector<SheetProfile> of_sheet = sheet_profiles(sheet, profiles);
    strips = strips_of<SheetStrip>(work, [&](std::size_t i, const Strip& strip,
                                             std::span<const LineAtDepth> which,
                                             std::span<const Segment> near_cut) {
      auto made = std::make_unique<SheetStrip>(sheet, i, strip);
      made->run(which, near_cut, of_sheet);
      return made;
    });
  }
  SectorParts out;
  std::size_t part_count = 0;
  for (const auto& strip : strips) part_count += strip->visible_parts().size();
  out.visible.reserve(part_count);
  for (const auto& made : strips) {
    throw_if_stopped();
    const SheetStrip& strip = *made;
    const std::vector<LinePart>& parts = strip.visible_parts();
    out.visible.insert(out.visible.end(), parts.begin(), parts.end());
    const Horizon top = strip.top();
    counts.largest_horizon = std::max<std::uint64_t>(counts.largest_horizon, top.size());
    const std::vector<LinePart> skyline = strip.pictures().skyline(top);
    out.skyline.insert(out.skyline.end(), skyline.begin(), skyline.end());
  }
  join(out.visible);
  join(out.skyline);
  out.skyline = shared(out.skyline, out.visible);
  watch.mark(seconds.clip);
  on_all_cores(profiles.size(), [&](std::size_t i) { stages.lay_out(profiles[i]); });
  for (TimedProfile& timed : profiles) {
    count(timed.profile, counts);
    show(timed.profile);
    timed.add_to(seconds);
  }
  return out;
}

} // namespace orograph
