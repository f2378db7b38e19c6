// SPDX-License-Identifier: GPL-3.0-or-later
#include "tone/seen_profiles.hpp"

#include "geometry/on_all_cores.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace orograph {
namespace {

// What stands this share of its depth in front of ground is no part of it.
constexpr double kFarInFront = 0.03;
// What a column shows so far.
struct ColumnHorizon {
  double y = -std::numeric_limits<double>::infinity();
  double depth_m = 0;
  std::size_t profile = 0; ///< that it is of
  float x_mm = 0, y_mm = 0;
  bool before_void = false; ///< behind it there is no ground so far
};

// How much of a step on the page lies across the line.
float across_mm(const SampledProfile& profile, std::size_t column, float dx_mm, float dy_mm) {
  const auto [tx, ty, length] = profile.way[column];
  return length > 0 ? std::abs(dx_mm * ty - dy_mm * tx) / length : std::abs(dy_mm);
}

} // namespace

std::vector<SeenProfile> seen_profiles(std::span<const SampledProfile> profiles,
                                       const PageColumns& columns, const View& view,
                                       const Box2& frame_mm, bool both_sides) {
  std::vector<SeenProfile> seen(profiles.size());
  for (SeenProfile& profile : seen) {
    profile.sight.assign(columns.count, Sight::none);
    profile.gap_mm.assign(columns.count, 0);
  }
  if (profiles.empty()) return seen;
  const double far_m = kFarInFront * (profiles.back().depth_m - profiles.front().depth_m);
  // y = z * per_z + from_0: what is seen is above all before it.
  const auto take = [&](const SampledProfile& profile, double per_z, double from_0, std::size_t j,
                        std::size_t i, ColumnHorizon& horizon) {
    const double y = profile.z_m[i] * per_z + from_0;
    if (!(y > horizon.y)) { // nor does ground that isn't there
      horizon.before_void = std::isnan(profile.z_m[i]);
      return;
    }
    const Vec2 page{profile.x_mm[i], profile.y_mm[i]};
    const bool is_on_page = page.x >= frame_mm.low.x && page.x <= frame_mm.high.x &&
                            page.y >= frame_mm.low.y && page.y <= frame_mm.high.y;
    if (is_on_page) {
      const bool has_front = horizon.y > -std::numeric_limits<double>::infinity();
      const double reach_m = view.is_perspective() ? kFarInFront * profile.depth_m : far_m;
      const bool goes_on =
          has_front && !horizon.before_void &&
          (j == horizon.profile + 1 || profile.depth_m - horizon.depth_m <= reach_m);
      seen[j].sight[i] = goes_on ? Sight::next : Sight::first;
      if (has_front && !horizon.before_void)
        seen[j].gap_mm[i] =
            across_mm(profile, i, profile.x_mm[i] - horizon.x_mm, profile.y_mm[i] - horizon.y_mm);
    }
    horizon = {y, profile.depth_m, j, profile.x_mm[i], profile.y_mm[i], false};
  };
  constexpr std::size_t kColumnsOfTask = 32;
  on_all_cores((columns.count + kColumnsOfTask - 1) / kColumnsOfTask, [&](std::size_t task) {
    const std::size_t first = task * kColumnsOfTask,
                      count = std::min(kColumnsOfTask, columns.count - first);
    std::array<ColumnHorizon, kColumnsOfTask> horizons, from_below; // these with -y
    for (std::size_t j = 0; j < profiles.size(); ++j) {
      const SampledProfile& profile = profiles[j];
      const double per_z = view.is_perspective() ? 1 / profile.depth_m : view.y_per_z,
                   from_0 = view.is_perspective() ? -view.eye_z_m * per_z
                                                  : profile.depth_m * view.y_per_v;
      for (std::size_t k = 0; k < count; ++k) {
        take(profile, per_z, from_0, j, first + k, horizons[k]);
        if (both_sides) take(profile, -per_z, -from_0, j, first + k, from_below[k]);
      }
    }
  });
  return seen;
}

} // namespace orograph
