// SPDX-License-Identifier: GPL-3.0-or-later
#include "profiles/project_profile.hpp"

#include <algorithm>

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

void project_profile(const Profile& profile, std::uint32_t number, const View& view,
                     ProjectedProfile& out, std::vector<Segment>& uprights) {
  const std::size_t count = profile.size();
  out.x.resize(count);
  out.y.resize(count);
  out.runs.clear();
  uprights.clear();
  // `project`, with what is the same for all taken out of the loop.
  const double v = profile.depth_m;
  if (view.is_perspective()) {
    const double per_depth = 1 / v;
    for (std::size_t i = 0; i < count; ++i) {
      out.x[i] = profile.u_m[i] * per_depth;
      out.y[i] = (profile.z_m[i] - view.eye_z_m) * per_depth;
    }
  } else {
    const double aside = v * view.x_per_v, above = v * view.y_per_v;
    for (std::size_t i = 0; i < count; ++i) {
      out.x[i] = profile.u_m[i] + aside;
      out.y[i] = profile.z_m[i] * view.y_per_z + above;
    }
  }
  const auto is_ground = [](Span span) { return span == Span::slope || span == Span::level; };
  // As nearly always: all of it is one slope.
  const auto slopes = std::count(profile.after.begin(), profile.after.end(), Span::slope);
  if (count > 1 && static_cast<std::size_t>(slopes) == count - 1 &&
      profile.after.back() == Span::gap) {
    out.runs.push_back({0, static_cast<std::uint32_t>(count - 1)});
    return;
  }
  for (std::uint32_t i = 0; i + 1 < count; ++i) {
    if (profile.after[i] == Span::wall)
      uprights.push_back(
          {out.x[i], out.y[i], out.x[i], out.y[i + 1], (std::uint64_t{number} << 32U) | i, 0});
    if (!is_ground(profile.after[i])) continue;
    const std::uint32_t first = i;
    while (i + 2 < count && is_ground(profile.after[i + 1])) ++i;
    out.runs.push_back({first, i + 1});
  }
}

} // namespace orograph
