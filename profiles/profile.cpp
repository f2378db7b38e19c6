// SPDX-License-Identifier: GPL-3.0-or-later
#include "profiles/profile.hpp"

#include <cstddef>
#include <cstring>

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
  if (count == 0) return;
  // Up to the next gap, which is found many bytes at a time; walls are rare.
  const Span* const after = profile.after.data();
  const auto next_of = [&](Span kind, std::size_t from) {
    const void* found = std::memchr(after + from, static_cast<int>(kind), count - from);
    return found ? static_cast<std::size_t>(static_cast<const Span*>(found) - after) : count;
  };
  std::size_t wall = next_of(Span::wall, 0);
  for (std::size_t first = 0; first < count; ++first) {
    const std::size_t gap = next_of(Span::gap, first);
    for (; wall < gap; wall = next_of(Span::wall, first)) {
      uprights.push_back({out.x[wall], out.y[wall], out.x[wall], out.y[wall + 1],
                          (std::uint64_t{number} << 32U) | wall, 0});
      if (first < wall)
        out.runs.push_back({static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(wall)});
      first = wall + 1;
    }
    if (first < gap)
      out.runs.push_back({static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(gap)});
    first = gap;
  }
}

} // namespace orograph
