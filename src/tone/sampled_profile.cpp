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

void find_ways_on_page(SampledProfile& profile) {
  constexpr std::size_t kBeside = 2;
  const std::size_t count = profile.z_m.size();
  profile.way.assign(count, {});
  std::size_t begin = 0; // of the ground that a column is on
  for (std::size_t i = 0; i < count; ++i) {
    if (std::isnan(profile.z_m[i])) {
      begin = i + 1;
      continue;
    }
    std::size_t right = i;
    while (right < i + kBeside && right + 1 < count && !std::isnan(profile.z_m[right + 1])) ++right;
    const std::size_t left = std::max(begin, i - std::min(i, kBeside));
    const float x = profile.x_mm[right] - profile.x_mm[left],
                y = profile.y_mm[right] - profile.y_mm[left];
    profile.way[i] = {x, y, std::sqrt(x * x + y * y)};
  }
}

void ProfileSampler::sample(double depth_m, SampledProfile& out) const {
  std::size_t count = 0;
  for (const SampledSector& sector : sectors_) count += sector.columns.count;
  out.depth_m = depth_m;
  out.z_m.assign(count, std::numeric_limits<double>::quiet_NaN());
  out.is_level.assign(count, 0);
  out.x_mm.assign(count, 0);
  out.y_mm.assign(count, 0);
  std::size_t first = 0;
  for (const SampledSector& sector : sectors_) {
    sample(depth_m, sector, first, out);
    first += sector.columns.count;
  }
  find_ways_on_page(out);
}

void ProfileSampler::sample(double depth_m, const SampledSector& sector, std::size_t first,
                            SampledProfile& out) const {
  const auto& [cutter, view, to_page, columns] = sector;
  thread_local HeightsAlong ground;
  const PlacesAlong at{columns.first_u_m(view, depth_m), columns.step_u_m(view, depth_m),
                       columns.count};
  cutter.heights(depth_m, at, ground);
  std::ranges::copy(ground.is_level, out.is_level.begin() + static_cast<std::ptrdiff_t>(first));
  for (std::size_t i = 0; i < columns.count; ++i) {
    if (std::isnan(ground.z_m[i])) continue;
    const ProfilePoint here{at[i], depth_m, ground.z_m[i]};
    const Vec2 plane = project(view, here);
    if (!(to_page.w(plane) > 0)) continue;
    Vec2 page = to_page(plane);
    if (page_) {
      const auto& fan = columns.fan[i];
      page = {page_->x_mm(fan.azimuth), page_->y_mm(page_->tangent(here))};
    }
    out.z_m[first + i] = ground.z_m[i];
    out.x_mm[first + i] = static_cast<float>(page.x);
    out.y_mm[first + i] = static_cast<float>(page.y);
  }
}

} // namespace orograph
