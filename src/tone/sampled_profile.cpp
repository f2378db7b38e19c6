// SPDX-License-Identifier: GPL-3.0-or-later
#include "tone/sampled_profile.hpp"

#include "profiles/profile.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace orograph {

PageColumns page_columns(XRange range, const Box2& frame_mm, double mm) {
  PageColumns columns;
  const double count = std::clamp(std::round(frame_mm.width() / mm), 1.0, 4096.0);
  columns.count = static_cast<std::size_t>(count);
  columns.begin = range.begin;
  columns.width = (range.end - range.begin) / count;
  columns.mm = frame_mm.width() / count;
  return columns;
}

void ProfileSampler::sample(double depth_m, SampledProfile& out) const {
  thread_local Profile profile;
  const URange asked = u_range(view_, depth_m, {columns_.edge(0), columns_.edge(columns_.count)});
  cutter_.cut(depth_m, std::array{asked}, profile);
  out.depth_m = depth_m;
  out.z_m.assign(columns_.count, std::numeric_limits<double>::quiet_NaN());
  out.is_level.assign(columns_.count, 0);
  out.x_mm.assign(columns_.count, 0);
  out.y_mm.assign(columns_.count, 0);
  std::size_t span = 0;
  for (std::size_t i = 0; i < columns_.count; ++i) {
    const double x = columns_.middle(i),
                 u = view_.is_perspective() ? x * depth_m : x - view_.x_per_v * depth_m;
    while (span + 1 < profile.size() && profile.u_m[span + 1] <= u) ++span;
    if (span + 1 >= profile.size()) break;
    if (u < profile.u_m[span] || profile.after[span] == Span::gap) continue;
    const double share = (u - profile.u_m[span]) / (profile.u_m[span + 1] - profile.u_m[span]);
    const double z = profile.z_m[span] + share * (profile.z_m[span + 1] - profile.z_m[span]);
    const Vec2 plane = project(view_, {u, depth_m, z});
    if (!(to_page_.w(plane) > 0)) continue;
    const Vec2 page = to_page_(plane);
    out.z_m[i] = z;
    out.is_level[i] = profile.after[span] == Span::level ? 1 : 0;
    out.x_mm[i] = static_cast<float>(page.x);
    out.y_mm[i] = static_cast<float>(page.y);
  }
}

} // namespace orograph
