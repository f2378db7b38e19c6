// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/error_budget.hpp"

#include "view/sectors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace orograph {
namespace {

// Ends of strokes are within this, or the two lines that cross there are, measured across
// (docs/how-it-works.md).
constexpr double kArithmetic_mm = 1e-9;

double rounding_mm(const WriteOptions& write) {
  const double half_diagonal = 0.5 * std::numbers::sqrt2;
  const double page_step = half_diagonal * kPageStep_mm;
  constexpr double kCairoStep_mm = 25.4 / 72 / 256; // fixed point with 8 bits after the point
  switch (write.format) {
  case Format::svg:
    return page_step;
  case Format::pdf:
  case Format::ps:
  case Format::eps:
    return page_step + half_diagonal * kCairoStep_mm;
  case Format::png:
    return page_step + half_diagonal * 25.4 / write.dpi;
  case Format::geojson:
  case Format::gpkg:
    return 0; // on the ground in full precision
  }
  return page_step;
}

// Length on the page, in mm, by which a step of 1 m of height moves a ray's point at its end. The
// ray is in homogeneous coordinates of the visibility plane; in a parallel view it has no end, and
// all points of it move alike.
double mm_per_height(const Scene& scene, Vec3 ray) {
  const auto& m = scene.to_page.m;
  const Vec3 page = scene.to_page.of(ray);
  return std::hypot(m[1] - m[7] * page.x / page.z, m[4] - m[7] * page.y / page.z) / page.z *
         (scene.view.is_perspective() ? 1 : scene.view.y_per_z);
}

// Rays over the window, its corners among them.
std::vector<Vec3> shown_rays(const View& view) {
  constexpr int kSteps = 4;
  std::vector<Vec3> rays;
  for (int i = 0; i <= kSteps; ++i)
    for (int k = 0; k <= kSteps; ++k)
      rays.push_back(ray_of_picture(view, {view.window.low.x + view.window.width() * i / kSteps,
                                           view.window.low.y + view.window.height() * k / kSteps}));
  return rays;
}

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

// The map plane is flat: how much more the earth's curvature, less refraction's 0.13 of it, would
// move the farthest ground than the nearest. (What moves everything alike only moves the picture.)
double geodesy_mm(const Terrain& terrain, const Scene& scene) {
  if (terrain.map.crs_wkt.empty()) return 0;
  constexpr double kEarthRadius_m = 6371e3, kRefraction = 0.13;
  const auto [nearest, farthest] = distances(scene);
  const double drop_per_m2 = (1 - kRefraction) / (2 * kEarthRadius_m);
  double greatest = 0;
  for (const Vec3& ray : shown_rays(scene.view)) {
    // A perspective ray with ground at a horizontal distance is as many times as long.
    const double moved = scene.view.is_perspective()
                             ? std::hypot(ray.x, ray.z) * (farthest - nearest)
                             : farthest * farthest;
    greatest = std::max(greatest, mm_per_height(scene, ray) * drop_per_m2 * moved);
  }
  return greatest;
}

// From the eye to the nearest ground there may be.
double least_distance_m(const Scene& scene) {
  const View& view = scene.view;
  double least = std::numeric_limits<double>::infinity();
  for (const Box3& box : scene.extent.blocks.boxes) {
    const auto aside = [](double at, double low, double high) {
      return std::max({low - at, at - high, 0.0});
    };
    const double k = view.exaggeration;
    least = std::min(least, std::hypot(aside(view.depth_origin_m.x, box.low.x, box.high.x),
                                       aside(view.depth_origin_m.y, box.low.y, box.high.y),
                                       aside(view.eye_z_m, k * box.low.z, k * box.high.z)));
  }
  return std::max(least, view.near_m);
}

// How far points of the surface are from where those that it stands for would be drawn. (Where two
// ridges nearly coincide in the picture, what one hides of the other may change by more.)
double level_of_detail_mm(const Terrain& terrain, const Scene& scene) {
  if (terrain.surface_error_m == 0) return 0;
  const View& view = scene.view;
  const double height_m = terrain.surface_error_m * view.exaggeration;
  const double nearest_m = view.is_perspective() ? least_distance_m(scene) : 1;
  double greatest = 0;
  for (const Vec3& ray : shown_rays(view)) {
    const double nearer = view.is_perspective() ? length(ray) / nearest_m : 1;
    greatest = std::max(greatest, mm_per_height(scene, ray) * height_m * nearer);
  }
  return greatest;
}

} // namespace

ErrorBudget error_budget(const Terrain& terrain, const Scene& scene,
                         const RenderSettings& settings) {
  ErrorBudget budget;
  budget.level_of_detail_mm = level_of_detail_mm(terrain, scene);
  if (settings.reading.overview) budget.level_of_detail_mm.reset();
  budget.simplification_mm = settings.simplify_mm;
  budget.visibility_tolerance_mm = settings.visibility_tolerance_mm;
  budget.arithmetic_mm = kArithmetic_mm;
  budget.geodesy_mm = geodesy_mm(terrain, scene);
  budget.rounding_mm = rounding_mm(settings.write);
  return budget;
}

} // namespace orograph
