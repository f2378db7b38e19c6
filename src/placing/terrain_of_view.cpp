// SPDX-License-Identifier: GPL-3.0-or-later
#include "placing/terrain_of_view.hpp"

#include "dem/extent.hpp"
#include "dem/limit_lean.hpp"
#include "dem/mesh/keep_within.hpp"
#include "dem/read/asked_window.hpp"
#include "dem/read/read_options.hpp"
#include "dem/terrain.hpp"
#include "geometry/error.hpp"
#include "placing/places.hpp"
#include "placing/terrain_facts.hpp"
#include "placing/view_in_frame.hpp"
#include "view/phigs_view.hpp"

#include <utility>

namespace orograph {
namespace {

// Of true heights, over the ground that they stand on.
Box3 true_box(const Grid& grid) {
  const GridSteps steps = steps_of(grid);
  const HeightRange heights = height_range(grid);
  return {{0, 0, heights.low_m},
          {(grid.columns - 1) * length(steps.column_m), (grid.rows - 1) * length(steps.row_m),
           heights.high_m}};
}

void reframe_at(TerrainData& terrain, Vec2 place, double exaggeration) {
  const double unit_deg = terrain.map.earth->unit_deg;
  reframe(terrain, unit_deg * place.x, unit_deg * place.y, exaggeration);
}

// Directions are those of the frame below the eye, and the eye's place depends on them.
void stand_below_eye(TerrainData& terrain, const ViewFile& file, double exaggeration) {
  reframe_at(terrain, {file.vrp_map.x, file.vrp_map.y}, exaggeration);
  if (file.projection != PhigsProjection::perspective) return;
  constexpr int kSteps =
      6; // each is nearer by the eye's distance from the VRP over the earth's radius
  for (int i = 0; i < kSteps; ++i) {
    const Vec3 eye = terrain.map.to_map(eye_m(phigs_view(file, terrain.map, 1)));
    reframe_at(terrain, {eye.x, eye.y}, exaggeration);
  }
}

} // namespace

void stand_on_earth(TerrainData& terrain, const ViewSpec& view) {
  if (!terrain.map.earth) return;
  if (view.curvature == Curvature::off)
    throw Error("`curvature` off: " + terrain.source + " is in degrees, on the earth's curvature",
                "for a flat picture bring it to a map plane first: gdalwarp -t_srs CRS -r cubic " +
                    in_command(terrain.paths) + " projected.tif");
  const double exaggeration = exaggeration_of(view, true_box(std::get<Grid>(terrain.surface)));
  if (view.file)
    stand_below_eye(terrain, *view.file, exaggeration);
  else
    reframe_at(terrain, given_place(view, terrain).value_or(map_bounds(terrain).centre()),
               exaggeration);
  limit_lean(std::get<Grid>(terrain.surface));
}

std::optional<TerrainData> cut_by_view(const TerrainData& terrain, const ViewSpec& view) {
  if (!view.file || !view.file->cuts() || !has_ground(terrain.surface)) return std::nullopt;
  // Of a view in a file nothing is chosen by the terrain.
  const double exaggeration = terrain.map.earth ? 1 : exaggeration_of(view, {});
  Tin kept = keep_within(terrain.surface, between_planes(*view.file, terrain.map, exaggeration));
  if (kept.triangles.empty())
    throw Error(view.file_name + ": front and back plane leave nothing of the terrain",
                "put them on either side of it");
  TerrainData out{.surface = std::move(kept),
                  .map = terrain.map,
                  .source = terrain.source,
                  .paths = terrain.paths,
                  .notes = terrain.notes,
                  .triangulation = terrain.triangulation,
                  .surface_error_m = terrain.surface_error_m,
                  .is_overview = terrain.is_overview};
  out.notes.push_back("The view's front and back plane cut the terrain: a TIN is left.");
  return out;
}

TerrainOfView::TerrainOfView(const TerrainData& whole, const ViewSpec& view) : whole_(whole) {
  if (whole.map.earth) {
    on_earth_ = whole;
    stand_on_earth(*on_earth_, view);
  }
  cut_ = cut_by_view(uncut(), view);
}

} // namespace orograph
