// SPDX-License-Identifier: GPL-3.0-or-later
#include "profiles/project_profile.hpp"

namespace orograph {

void project_profile(const Profile& profile, std::uint32_t number, const View& view,
                     std::vector<Segment>& out, std::vector<Segment>& uprights) {
  out.clear();
  uprights.clear();
  const std::uint64_t first_id = std::uint64_t{number} << 32U;
  const auto at = [&](std::size_t i) {
    return project(view, {profile.u_m[i], profile.depth_m, profile.z_m[i]});
  };
  for (std::size_t i = 0; i + 1 < profile.size(); ++i) {
    if (profile.after[i] == Span::gap) continue;
    const Vec2 left = at(i), right = at(i + 1);
    if (profile.after[i] == Span::wall)
      uprights.push_back({left.x, left.y, left.x, right.y, first_id | i, 0});
    else if (left.x < right.x)
      out.push_back({left.x, left.y, right.x, right.y, first_id | i});
  }
}

} // namespace orograph
