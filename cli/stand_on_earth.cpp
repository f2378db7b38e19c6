// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/stand_on_earth.hpp"

#include "cli/map_bounds.hpp"
#include "cli/place_eye.hpp"
#include "cli/scene.hpp"
#include "cli/scene_view.hpp"
#include "dem/extent.hpp"
#include "dem/height_range.hpp"
#include "dem/read/in_brief.hpp"
#include "dem/reframe.hpp"
#include "geometry/error.hpp"
#include "view/profile_frame.hpp"

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

void reframe_at(Terrain& terrain, Vec2 place, double exaggeration) {
  const double unit_deg = terrain.map.earth->unit_deg;
  reframe(terrain, unit_deg * place.x, unit_deg * place.y, exaggeration);
}

// Directions are those of the frame below the eye, and the eye's place depends on them.
void stand_below_eye(Terrain& terrain, const ViewFile& file, double exaggeration) {
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

void stand_on_earth(Terrain& terrain, const RenderSettings& settings) {
  if (!terrain.map.earth) return;
  if (settings.curvature == Curvature::off)
    throw Error("--curvature off: " + terrain.source + " is in degrees, on the earth's curvature",
                "for a flat picture bring it to a map plane first: gdalwarp -t_srs CRS -r cubic " +
                    in_command(terrain.paths) + " projected.tif");
  const double exaggeration = exaggeration_of(settings, true_box(std::get<Grid>(terrain.surface)));
  if (settings.view)
    stand_below_eye(terrain, *settings.view, exaggeration);
  else
    reframe_at(terrain, given_place(settings, terrain).value_or(map_bounds(terrain).centre()),
               exaggeration);
}

} // namespace orograph
