// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/error_budget.hpp"

#include "view/place_view.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

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

// The map plane is flat: how much more the earth's curvature, less refraction's 0.13 of it, would
// move the farthest ground than the nearest. (What moves everything alike only moves the picture.)
double geodesy_mm(const Terrain& terrain, const Scene& scene) {
  if (terrain.map.crs_wkt.empty()) return 0;
  constexpr double kEarthRadius_m = 6371e3, kRefraction = 0.13;
  const View& view = scene.view;
  const double nearest = scene.depths_m.front(), farthest = scene.depths_m.back();
  const double drop_per_m2 = (1 - kRefraction) / (2 * kEarthRadius_m);
  double greatest = 0;
  for (const Vec2& corner : shown_corners(view)) {
    // In perspective a point at depth v and X is v * sqrt(1 + X²) away.
    const double u = std::abs(corner.x) +
                     std::abs(view.x_per_v) * std::max(std::abs(nearest), std::abs(farthest));
    const double moved =
        view.is_perspective()
            ? (1 + corner.x * corner.x) * (farthest - nearest)
            : (u * u + std::max(nearest * nearest, farthest * farthest)) * view.y_per_z;
    greatest = std::max(greatest, scene.to_page.mm_per_y(corner) * drop_per_m2 * moved);
  }
  return greatest;
}

// How far points of the surface are from where those that it stands for would be drawn. (Where two
// ridges nearly coincide in the picture, what one hides of the other may change by more.)
double level_of_detail_mm(const Terrain& terrain, const Scene& scene) {
  const View& view = scene.view;
  const double height_m = terrain.surface_error_m * view.exaggeration;
  const double per_height =
      view.is_perspective() ? 1 / std::max(scene.nearest_m, view.near_m) : view.y_per_z;
  double greatest = 0;
  for (const Vec2& corner : shown_corners(view))
    greatest = std::max(greatest, scene.to_page.mm_per_y(corner) * height_m * per_height);
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
