// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/error_budget.hpp"

#include "cli/geodesy.hpp"

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

// What the drawing leaves out of the earth's shape.
double geodesy_mm(const Terrain& terrain, const Scene& scene, const RenderSettings& settings) {
  if (terrain.map.crs_wkt.empty()) return 0;
  const bool eye_is_given = settings.eye_map || settings.eye_lonlat || settings.view;
  const double flat_mm = scene.curvature.applied ? 0 : scene.curvature.would_move_mm;
  return flat_mm + map_plane_mm(scene, terrain.map, eye_is_given);
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
  budget.geodesy_mm = geodesy_mm(terrain, scene, settings);
  budget.rounding_mm = rounding_mm(settings.write);
  return budget;
}

} // namespace orograph
