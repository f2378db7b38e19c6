// SPDX-License-Identifier: GPL-3.0-or-later
#include "profiles/shown_depths.hpp"

#include "view/sectors.hpp"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <limits>

namespace orograph {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

DepthRange in_parallel(const PlanGround& ground, const View& view) {
  double low = kInfinity, high = -kInfinity;
  for (const Vec3& ray : corner_rays(view)) {
    low = std::min(low, ray.y);
    high = std::max(high, ray.y);
  }
  const double middle = ground.mean_z_m * view.y_per_z, relief = ground.relief_m * view.y_per_z;
  if (!(view.y_per_v > 0)) return {-kInfinity, kInfinity}; // Y tells nothing of depth
  // Far off, ground has sunk, or risen, by the earth's curvature.
  const double farthest_m = std::max(std::abs(ground.nearest_m), std::abs(ground.farthest_m));
  const double sunk = std::abs(view.drop.at(0, farthest_m)) * view.y_per_z;
  return {(low - middle - relief - sunk) / view.y_per_v,
          (high - middle + relief + sunk) / view.y_per_v};
}

DepthRange in_perspective(const PlanGround& ground, const View& view) {
  const std::array<Vec3, 4> rays = corner_rays(view);
  // Of ground, from the eye's height; it sinks by the earth's curvature.
  const double mean = ground.mean_z_m - view.eye_z_m;
  const double sunk =
      std::abs(view.drop.at(0, std::max(std::abs(ground.nearest_m), ground.farthest_m)));
  const double top = mean + ground.relief_m, bottom = mean - ground.relief_m - sunk;
  const auto all = [&](auto holds) { return std::ranges::all_of(rays, holds); };
  const bool down = all([](Vec3 r) { return r.y < 0; }), up = all([](Vec3 r) { return r.y > 0; });
  const bool ahead = all([](Vec3 r) { return r.z > 0; });
  if ((down && bottom >= 0) || (up && top <= 0)) return {0, 0};
  DepthRange range{kInfinity, -kInfinity};
  const auto take = [&](Vec3 ray, double height) {
    const double depth = ray.z * height / ray.y;
    range.nearest_m = std::min(range.nearest_m, depth);
    range.farthest_m = std::max(range.farthest_m, depth);
  };
  if (down || up) {
    for (const Vec3& ray : rays)
      for (const double height :
           {down ? bottom : std::max(bottom, 0.0), down ? std::min(top, 0.0) : top})
        take(ray, height);
    return range;
  }
  // Level rays are among them, which may meet ground at any distance.
  if (!ahead) return {-kInfinity, kInfinity};
  for (const Vec3& ray : rays)
    if (ray.y < 0) take(ray, std::min(top, 0.0));
  return {top > 0 ? 0 : range.nearest_m, kInfinity};
}

} // namespace

DepthRange shown_depths(const PlanGround& ground, const View& view) {
  DepthRange range{ground.nearest_m, ground.farthest_m};
  if (view.is_perspective() && !shows_beside(view))
    range.nearest_m = std::max(range.nearest_m, view.near_m);
  if (view.frames_terrain) return range;
  const DepthRange shown =
      view.is_perspective() ? in_perspective(ground, view) : in_parallel(ground, view);
  range.nearest_m =
      std::clamp(shown.nearest_m, range.nearest_m, std::max(range.nearest_m, range.farthest_m));
  range.farthest_m =
      std::clamp(shown.farthest_m, range.nearest_m, std::max(range.nearest_m, range.farthest_m));
  return range;
}

} // namespace orograph
