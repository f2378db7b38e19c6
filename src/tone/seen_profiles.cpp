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

constexpr std::size_t kColumnsOfTask = 64;

// Of neighbouring columns of a profile, the way on the page from what they show in front.
struct StepsOnPage {
  std::array<float, kColumnsOfTask> x_mm, y_mm;
};

// How much of each step lies across the line, which goes there as it does between two columns on
// either side, or as many as have ground all the way.
void take_across(const SampledProfile& profile, std::size_t first, std::size_t count,
                 const StepsOnPage& steps, float* gap_mm) {
  constexpr std::size_t kBeside = 2;
  std::array<float, kColumnsOfTask + 2 * kBeside> x_mm, y_mm; // NaN is no ground
  const std::size_t all = profile.x_mm.size(), from = first - std::min(first, kBeside),
                    to = std::min(first + count + kBeside, all), missing = from + kBeside - first;
  x_mm.fill(std::numeric_limits<float>::quiet_NaN());
  std::copy_n(profile.x_mm.data() + from, to - from, x_mm.data() + missing);
  std::copy_n(profile.y_mm.data() + from, to - from, y_mm.data() + missing);
  for (std::size_t k = 0; k < count; ++k) {
    const float x = x_mm[k + 2], y = y_mm[k + 2], x_left = x_mm[k + 1], y_left = y_mm[k + 1],
                x_lefter = x_mm[k], y_lefter = y_mm[k], x_right = x_mm[k + 3],
                y_right = y_mm[k + 3], x_righter = x_mm[k + 4], y_righter = y_mm[k + 4];
    const bool one_left = !std::isnan(x_left), one_right = !std::isnan(x_right),
               two_left = one_left & !std::isnan(x_lefter),
               two_right = one_right & !std::isnan(x_righter);
    const float from_x = two_left   ? x_lefter
                         : one_left ? x_left
                                    : x,
                from_y = two_left   ? y_lefter
                         : one_left ? y_left
                                    : y,
                to_x = two_right   ? x_righter
                       : one_right ? x_right
                                   : x,
                to_y = two_right   ? y_righter
                       : one_right ? y_right
                                   : y;
    const float way_x = to_x - from_x, way_y = to_y - from_y;
    const float length_mm = std::sqrt(way_x * way_x + way_y * way_y);
    const float across = std::abs(steps.x_mm[k] * way_y - steps.y_mm[k] * way_x);
    gap_mm[k] = length_mm > 0 ? across / length_mm : std::abs(steps.y_mm[k]);
  }
}

// The y of ground in its column: what is seen is above all before it.
struct YOfHeight {
  double per_z, from_0;
};

YOfHeight y_of_height(const View& view, double depth_m) {
  if (!view.is_perspective()) return {view.y_per_z, depth_m * view.y_per_v};
  return {1 / depth_m, -view.eye_z_m * (1 / depth_m)};
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
  const auto is_on_page = [&](double x_mm, double y_mm) {
    return x_mm >= frame_mm.low.x && x_mm <= frame_mm.high.x && y_mm >= frame_mm.low.y &&
           y_mm <= frame_mm.high.y;
  };
  // Neighbouring columns of a profile. Whether any shows ground behind other.
  const auto take = [&](std::size_t j, std::size_t first, YOfHeight y_of,
                        std::span<ColumnHorizon> horizons, StepsOnPage& steps) {
    const double depth_m = profiles[j].depth_m;
    const double reach_m = view.is_perspective() ? kFarInFront * depth_m : far_m;
    const double* const z_m = profiles[j].z_m.data() + first;
    const float *const xs_mm = profiles[j].x_mm.data() + first, *const ys_mm =
                                                                    profiles[j].y_mm.data() + first;
    Sight* const sight = seen[j].sight.data() + first;
    bool any = false;
    for (std::size_t k = 0; k < horizons.size(); ++k) {
      ColumnHorizon& horizon = horizons[k];
      const double y = z_m[k] * y_of.per_z + y_of.from_0;
      if (!(y > horizon.y)) { // nor does ground that isn't there
        horizon.before_void = std::isnan(z_m[k]);
        continue;
      }
      const float x_mm = xs_mm[k], y_mm = ys_mm[k];
      if (is_on_page(x_mm, y_mm)) {
        const bool has_front =
            horizon.y > -std::numeric_limits<double>::infinity() && !horizon.before_void;
        const bool goes_on =
            has_front && (j == horizon.profile + 1 || depth_m - horizon.depth_m <= reach_m);
        sight[k] = goes_on ? Sight::next : Sight::first;
        if (has_front) {
          any = true;
          steps.x_mm[k] = x_mm - horizon.x_mm;
          steps.y_mm[k] = y_mm - horizon.y_mm;
        }
      }
      horizon = {y, depth_m, j, x_mm, y_mm, false};
    }
    return any;
  };
  on_all_cores((columns.count + kColumnsOfTask - 1) / kColumnsOfTask, [&](std::size_t task) {
    const std::size_t first = task * kColumnsOfTask,
                      count = std::min(kColumnsOfTask, columns.count - first);
    std::array<ColumnHorizon, kColumnsOfTask> from_above, from_below; // these with -y
    for (std::size_t j = 0; j < profiles.size(); ++j) {
      const YOfHeight y_of = y_of_height(view, profiles[j].depth_m);
      StepsOnPage steps{};
      bool any = take(j, first, y_of, std::span(from_above).first(count), steps);
      if (both_sides)
        any |=
            take(j, first, {-y_of.per_z, -y_of.from_0}, std::span(from_below).first(count), steps);
      if (any) take_across(profiles[j], first, count, steps, seen[j].gap_mm.data() + first);
    }
  });
  return seen;
}

} // namespace orograph
