// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/geodesy.hpp"

#include "view/sectors.hpp"

#include <algorithm>
#include <cmath>

namespace orograph {
namespace {

// Of the terrain, from where depth is 0: least and greatest horizontal distance.
struct Distances {
  double nearest_m, farthest_m;
};
Distances distances(const Scene& scene) {
  const auto& [low, high] = scene.extent.box;
  const Vec2 at = scene.view.depth_origin_m;
  const double aside_x = std::max({low.x - at.x, at.x - high.x, 0.0}),
               aside_y = std::max({low.y - at.y, at.y - high.y, 0.0});
  return {std::hypot(aside_x, aside_y),
          std::hypot(std::max(at.x - low.x, high.x - at.x), std::max(at.y - low.y, high.y - at.y))};
}

// The same as `mm_per_height` of a step to the side.
double mm_per_aside(const Scene& scene, Vec3 ray) {
  const auto& m = scene.to_page.m;
  const Vec3 page = scene.to_page.of(ray);
  return std::hypot(m[0] - m[6] * page.x / page.z, m[3] - m[6] * page.y / page.z) / page.z;
}

} // namespace

EarthDrop earth_drop(const MapFrame& map, double refraction) {
  const auto [meridian_m, prime_vertical_m] =
      map.radii.value_or(CurvatureRadii{kMeanEarthRadius_m, kMeanEarthRadius_m});
  return {(1 - refraction) / (2 * meridian_m), (1 - refraction) / (2 * prime_vertical_m)};
}

double mm_per_height(const Scene& scene, Vec3 ray) {
  const auto& m = scene.to_page.m;
  const Vec3 page = scene.to_page.of(ray);
  return std::hypot(m[1] - m[7] * page.x / page.z, m[4] - m[7] * page.y / page.z) / page.z *
         (scene.view.is_perspective() ? 1 : scene.view.y_per_z);
}

std::vector<Vec3> shown_rays(const View& view) {
  constexpr int kSteps = 4;
  std::vector<Vec3> rays;
  for (int i = 0; i <= kSteps; ++i)
    for (int k = 0; k <= kSteps; ++k)
      rays.push_back(ray_of_picture(view, {view.window.low.x + view.window.width() * i / kSteps,
                                           view.window.low.y + view.window.height() * k / kSteps}));
  return rays;
}

double drop_mm(const Scene& scene, const EarthDrop& drop) {
  const auto [nearest, farthest] = distances(scene);
  const double per_m2 = std::max(std::abs(drop.per_north), std::abs(drop.per_east));
  double greatest = 0;
  for (const Vec3& ray : shown_rays(scene.view)) {
    // A perspective ray with ground at a horizontal distance is as many times as long.
    const double moved = scene.view.is_perspective()
                             ? std::hypot(ray.x, ray.z) * (farthest - nearest)
                             : farthest * farthest;
    greatest = std::max(greatest, mm_per_height(scene, ray) * per_m2 * moved);
  }
  return greatest;
}

double map_plane_mm(const Scene& scene) {
  constexpr double kHalfZone_m = 334e3;
  const double farthest = distances(scene).farthest_m;
  const double share = farthest * kHalfZone_m / (kMeanEarthRadius_m * kMeanEarthRadius_m);
  double greatest = 0;
  for (const Vec3& ray : shown_rays(scene.view)) {
    const double reach = scene.view.is_perspective() ? std::hypot(ray.x, ray.z) : farthest;
    greatest = std::max(greatest, mm_per_aside(scene, ray) * share * reach);
  }
  return greatest;
}

} // namespace orograph
