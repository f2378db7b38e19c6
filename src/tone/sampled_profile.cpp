// SPDX-License-Identifier: GPL-3.0-or-later
#include "tone/sampled_profile.hpp"

#include "profiles/heights_along.hpp"

#include <algorithm>
#include <array>
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

void ProfileSampler::sample(std::span<SampledProfile* const> profiles) const {
  std::size_t count = 0;
  for (const SampledSector& sector : sectors_) count += sector.columns.count;
  for (SampledProfile* const out : profiles) {
    out->z_m.assign(count, std::numeric_limits<double>::quiet_NaN());
    out->is_level.assign(count, 0);
    out->x_mm.assign(count, std::numeric_limits<float>::quiet_NaN());
    out->y_mm.assign(count, std::numeric_limits<float>::quiet_NaN());
  }
  std::size_t first = 0;
  for (const SampledSector& sector : sectors_) {
    sample(sector, first, profiles);
    first += sector.columns.count;
  }
}

void ProfileSampler::sample(const SampledSector& sector, std::size_t first,
                            std::span<SampledProfile* const> profiles) const {
  const auto& [cutter, view, to_page, columns] = sector;
  thread_local std::array<HeightsAlong, kAtOnce> grounds; // asked for once
  std::vector<AskedProfile> asked;
  for (const SampledProfile* const profile : profiles) {
    const double depth_m = profile->depth_m;
    const PlacesAlong at{columns.first_u_m(view, depth_m), columns.step_u_m(view, depth_m),
                         columns.count};
    asked.push_back({depth_m, at, &grounds[asked.size()]});
  }
  cutter.heights(asked);
  for (std::size_t k = 0; k < profiles.size(); ++k) {
    const auto& [depth_m, at, ground] = asked[k];
    SampledProfile& out = *profiles[k];
    std::ranges::copy(ground->is_level, out.is_level.begin() + static_cast<std::ptrdiff_t>(first));
    for (std::size_t i = 0; i < columns.count; ++i) {
      if (std::isnan(ground->z_m[i])) continue;
      const ProfilePoint here{at[i], depth_m, ground->z_m[i]};
      const Vec2 plane = project(view, here);
      if (!(to_page.w(plane) > 0)) continue;
      Vec2 page = to_page(plane);
      if (page_) {
        const auto& fan = columns.fan[i];
        page = {page_->x_mm(fan.azimuth), page_->y_mm(page_->tangent(here))};
      }
      out.z_m[first + i] = ground->z_m[i];
      out.x_mm[first + i] = static_cast<float>(page.x);
      out.y_mm[first + i] = static_cast<float>(page.y);
    }
  }
}

} // namespace orograph
