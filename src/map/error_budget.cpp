// SPDX-License-Identifier: GPL-3.0-or-later
#include "map/error_budget.hpp"

#include "dem/extent.hpp"
#include "draw/stroke_builder.hpp"
#include "placing/geodesy.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace orograph {
namespace {

// Ends of strokes are within this, or the two lines that cross there are, measured across
// (docs/how-it-works.md).
constexpr double kArithmetic_mm = 1e-9;

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
  double squared = 0;
  for (const auto& corners : tin.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 side = tin.vertices_m[corners[i]] - tin.vertices_m[corners[(i + 1) % 3]];
      squared = std::max(squared, side.x * side.x + side.y * side.y);
    }
  return std::sqrt(squared);
}

// What the drawing leaves out of the earth's shape. Without a CRS there is no earth; with one that
// doesn't tell where on it, only its roundness.
std::optional<double> geodesy_mm(const TerrainData& terrain, const PlacedView& placed,
                                 const MapSpec& spec) {
  if (terrain.map.crs_wkt.empty() && !placed.curvature.applied) return 0;
  const EarthDrop drop = earth_drop(terrain.map, placed.curvature.refraction);
  const double sag = sag_mm(placed, drop, longest_edge_m(terrain.surface));
  if (terrain.map.earth) // the ellipsoid itself; refraction where it is drawn
    return placed.curvature.refraction != 0 ? sag : placed.curvature.would_move_mm;
  const double round_mm =
      placed.curvature.applied ? parabola_mm(placed) + sag : placed.curvature.would_move_mm;
  if (!terrain.map.radii) return round_mm;
  const bool eye_is_given = spec.view.eye_map || spec.view.eye_lonlat || spec.view.file;
  const auto plane_mm = map_plane_mm(placed, terrain.map, eye_is_given);
  if (!plane_mm) return std::nullopt;
  return round_mm + *plane_mm;
}

} // namespace

double level_of_detail_mm(const TerrainData& terrain, const PlacedView& placed,
                          const std::optional<LevelOfDetail>& level) {
  const double of_level_mm = level ? level->greatest_mm : 0;
  if (terrain.surface_error_m == 0) return of_level_mm;
  const View& view = placed.view;
  const double height_m = terrain.surface_error_m * view.exaggeration;
  const double nearest_m = view.is_perspective() ? least_distance_m(placed) : 1;
  double greatest = 0;
  for (const Vec3& ray : shown_rays(view)) {
    const double nearer = view.is_perspective() ? length(ray) / nearest_m : 1;
    greatest = std::max(greatest, mm_per_height(placed, ray) * height_m * nearer);
  }
  return greatest + of_level_mm;
}

ErrorBudget error_budget(const TerrainData& terrain, const PlacedView& placed, const MapSpec& spec,
                         const std::optional<LevelOfDetail>& level) {
  ErrorBudget budget;
  budget.level_of_detail_mm = level_of_detail_mm(terrain, placed, level);
  if (terrain.is_overview) budget.level_of_detail_mm.reset();
  budget.simplification_mm = spec.style.simplify_mm;
  budget.joining_mm = spec.ground_points ? 0 : 0.5 * spec.style.join_mm; // no gap is bridged there
  const bool draws_shores = (spec.style.asks_for("shores") || spec.style.draws_waterlines()) &&
                            !placed.level.shores.empty();
  budget.shore_smoothing_mm = draws_shores && !spec.ground_points ? spec.style.shore_smooth_mm : 0;
  budget.visibility_tolerance_mm = spec.style.visibility_tolerance_mm;
  budget.arithmetic_mm = kArithmetic_mm;
  if (placed.panorama) budget.arithmetic_mm += panorama_bend_mm(spec.style.simplify_mm);
  budget.geodesy_mm = geodesy_mm(terrain, placed, spec);
  budget.rounding_mm = page_rounding_mm();
  return budget;
}

} // namespace orograph
