// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/error_budget.hpp"

#include "cli/geodesy.hpp"
#include "dem/extent.hpp"

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

// A diagonal, in metres; on the ellipsoid of the cells nearest to the equator.
double longest_edge_m(const Grid& grid) {
  if (!grid.is_on_earth()) {
    const PlaneLattice& lattice = grid.plane();
    return std::max({length(lattice.column_step_m), length(lattice.row_step_m),
                     length(lattice.column_step_m + lattice.row_step_m)});
  }
  const EarthLattice& earth = grid.earth();
  const DegreeLattice& lattice = earth.degrees();
  const double equator = -lattice.first_lat_deg / lattice.lat_step_deg;
  const int row = static_cast<int>(std::clamp(equator, 0.0, grid.rows - 2.0));
  double longest = 0;
  for (const int r : {row, std::max(row - 1, 0)})
    longest = std::max({longest, length(earth.vertex_m(1, r + 1, 0) - earth.vertex_m(0, r, 0)),
                        length(earth.vertex_m(1, r, 0) - earth.vertex_m(0, r + 1, 0))});
  return longest;
}

double longest_edge_m(const Surface& surface) {
  if (const Grid* grid = std::get_if<Grid>(&surface)) return longest_edge_m(*grid);
  const Tin& tin = std::get<Tin>(surface);
  double longest = 0;
  for (const auto& corners : tin.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 side = tin.vertices_m[corners[i]] - tin.vertices_m[corners[(i + 1) % 3]];
      longest = std::max(longest, std::hypot(side.x, side.y));
    }
  return longest;
}

// What the drawing leaves out of the earth's shape. Without a CRS there is no earth; with one that
// doesn't tell where on it, only its roundness.
std::optional<double> geodesy_mm(const Terrain& terrain, const Scene& scene,
                                 const RenderSettings& settings) {
  if (terrain.map.crs_wkt.empty() && !scene.curvature.applied) return 0;
  const EarthDrop drop = earth_drop(terrain.map, scene.curvature.refraction);
  const double sag = sag_mm(scene, drop, longest_edge_m(terrain.surface));
  if (terrain.map.earth) // the ellipsoid itself; refraction where it is drawn
    return scene.curvature.refraction != 0 ? sag : scene.curvature.would_move_mm;
  const double round_mm =
      scene.curvature.applied ? parabola_mm(scene) + sag : scene.curvature.would_move_mm;
  if (!terrain.map.radii) return round_mm;
  const bool eye_is_given = settings.eye_map || settings.eye_lonlat || settings.view;
  const auto plane_mm = map_plane_mm(scene, terrain.map, eye_is_given);
  if (!plane_mm) return std::nullopt;
  return round_mm + *plane_mm;
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
