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

namespace {

// All that isn't known, or isn't in front of the picture, is NaN. What is the same of all columns
// is copied: only so does the compiler see that nothing here changes it.
void put_on_page(View view, Homography to_page, const AskedProfile& asked, SampledProfile& out,
                 std::size_t first) {
  const PlacesAlong at = asked.at;
  const double depth_m = asked.depth_m;
  const double* const ground_z_m = asked.heights->z_m.data();
  constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();
  double* const z_m = out.z_m.data() + first;
  float *const x_mm = out.x_mm.data() + first, *const y_mm = out.y_mm.data() + first;
  for (std::size_t i = 0; i < at.count; ++i) {
    const double ground = ground_z_m[i];
    const Vec2 plane = project(view, {at[i], depth_m, ground});
    const Vec2 page = to_page(plane);
    const bool is_shown = to_page.w(plane) > 0;
    z_m[i] = is_shown ? ground : kMissing;
    x_mm[i] = static_cast<float>(is_shown ? page.x : kMissing);
    y_mm[i] = static_cast<float>(is_shown ? page.y : kMissing);
  }
}

} // namespace

void ProfileSampler::make_room(SampledProfile& profile) const {
  std::size_t count = 0;
  for (const SampledSector& sector : sectors_) count += sector.columns.count;
  profile.z_m.resize(count);
  profile.is_level.resize(count);
  profile.x_mm.resize(count);
  profile.y_mm.resize(count);
}

void ProfileSampler::sample(std::span<SampledProfile* const> profiles) const {
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
    const HeightsAlong& ground = *asked[k].heights;
    SampledProfile& out = *profiles[k];
    std::ranges::copy(ground.is_level, out.is_level.begin() + static_cast<std::ptrdiff_t>(first));
    put_on_page(sector.view, sector.to_page, asked[k], out, first);
    if (!page_) continue;
    for (std::size_t i = 0; i < columns.count; ++i) {
      if (std::isnan(out.z_m[first + i])) continue;
      const ProfilePoint here{asked[k].at[i], asked[k].depth_m, ground.z_m[i]};
      out.x_mm[first + i] = static_cast<float>(page_->x_mm(columns.fan[i].azimuth));
      out.y_mm[first + i] = static_cast<float>(page_->y_mm(page_->tangent(here)));
    }
  }
}

} // namespace orograph
