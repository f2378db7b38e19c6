// SPDX-License-Identifier: GPL-3.0-or-later
#include "tone/sampled_profile.hpp"

#include "profiles/heights_along.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace orograph {

PageColumns page_columns(XRange range, bool of_u, const Box2& frame_mm, double mm) {
  PageColumns columns;
  const double count = std::clamp(std::round(frame_mm.width() / mm), 1.0, 4096.0);
  columns.count = static_cast<std::size_t>(count);
  columns.of_u = of_u;
  columns.begin = range.begin;
  columns.width = (range.end - range.begin) / count;
  columns.mm = frame_mm.width() / count;
  return columns;
}

void ProfileSampler::sample(double depth_m, SampledProfile& out) const {
  thread_local HeightsAlong ground;
  const PlacesAlong at{columns_.first_u_m(view_, depth_m), columns_.step_u_m(view_, depth_m),
                       columns_.count};
  cutter_.heights(depth_m, at, ground);
  out.depth_m = depth_m;
  out.z_m.assign(columns_.count, std::numeric_limits<double>::quiet_NaN());
  out.is_level = ground.is_level;
  out.x_mm.assign(columns_.count, 0);
  out.y_mm.assign(columns_.count, 0);
  for (std::size_t i = 0; i < columns_.count; ++i) {
    if (std::isnan(ground.z_m[i])) continue;
    const Vec2 plane = project(view_, {at[i], depth_m, ground.z_m[i]});
    if (!(to_page_.w(plane) > 0)) continue;
    const Vec2 page = to_page_(plane);
    out.z_m[i] = ground.z_m[i];
    out.x_mm[i] = static_cast<float>(page.x);
    out.y_mm[i] = static_cast<float>(page.y);
  }
}

} // namespace orograph
