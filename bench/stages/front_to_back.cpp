// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/stages/front_to_back.hpp"

#include "hidden_lines/strip_pass.hpp"

namespace orograph {

PassFound pass_front_to_back(const StagedView& view, const std::vector<EdgeLine>& lines,
                             PassMeters& meters,
                             const std::function<void(const ProfileInWork&)>& profile_done) {
  const SectorInWork work = view.work_with(lines);
  const Sector& sector = view.sector();
  const auto strips = strips_of(work);
  PassFound found;
  ProfileInWork profile;
  profile.by_strip.resize(strips.size());
  for (const PlannedProfile& planned : sector.profiles) {
    profile.planned = planned;
    view.cutter.cut(planned.depth_m, profile.profile);
    project_profile(profile.profile, static_cast<std::uint32_t>(planned.number), sector.view,
                    profile.projected, profile.uprights);
    meters.lines.measure([&] {
      for (const auto& strip : strips) strip->take_lines(planned.depth_m);
    });
    meters.profiles.measure([&] {
      for (std::size_t i = 0; i < strips.size(); ++i)
        strips[i]->take_profile(profile, profile.by_strip[i]);
    });
    found.cut_vertices += profile.profile.size();
    profile_done(profile);
  }
  meters.lines.measure([&] {
    for (const auto& strip : strips) strip->finish();
  });
  for (const auto& strip : strips) {
    const std::vector<LinePart>& parts = strip->visible_parts();
    found.visible.insert(found.visible.end(), parts.begin(), parts.end());
  }
  return found;
}

} // namespace orograph
