// SPDX-License-Identifier: GPL-3.0-or-later
#include "placing/terrain_for_views.hpp"

#include "dem/extent.hpp"
#include "dem/limit_lean.hpp"
#include "dem/read/asked_window.hpp"
#include "dem/read/read_options.hpp"
#include "geometry/error.hpp"
#include "geometry/on_all_cores.hpp"
#include "placing/places.hpp"
#include "placing/view_in_frame.hpp"
#include "view/phigs_view.hpp"

#include <chrono>
#include <utility>

namespace orograph {
namespace {

// Of true heights, over the ground that they stand on; of a terrain in degrees.
Box3 true_box(const TerrainData& terrain) {
  const Grid& grid = std::get<Grid>(terrain.surface);
  const GridSteps steps = steps_of(grid);
  const HeightRange heights = height_range(grid);
  return {{0, 0, heights.low_m},
          {(grid.columns - 1) * length(steps.column_m), (grid.rows - 1) * length(steps.row_m),
           heights.high_m}};
}

void reframe_at(TerrainData& terrain, const GroundOrigin& origin) {
  const double unit_deg = terrain.map.earth->unit_deg;
  reframe(terrain, unit_deg * origin.place_map.x, unit_deg * origin.place_map.y,
          origin.exaggeration);
}

// Directions are those of the frame below the eye, and the eye's place depends on them.
void stand_below_eye(TerrainData& terrain, const ViewFile& file, double exaggeration) {
  reframe_at(terrain, {{file.vrp_map.x, file.vrp_map.y}, exaggeration});
  if (file.projection != PhigsProjection::perspective) return;
  constexpr int kSteps =
      6; // each is nearer by the eye's distance from the VRP over the earth's radius
  for (int i = 0; i < kSteps; ++i) {
    const Vec3 eye = terrain.map.to_map(eye_m(phigs_view(file, terrain.map, 1)));
    reframe_at(terrain, {{eye.x, eye.y}, exaggeration});
  }
}

// Of a terrain with a `true_box`. None for a view in a file.
std::optional<GroundOrigin> ground_origin(const TerrainData& terrain, const Box3& box,
                                          const ViewSpec& view) {
  if (view.curvature == Curvature::off)
    throw Error("`curvature` off: " + terrain.source + " is in degrees, on the earth's curvature",
                "for a flat picture bring it to a map plane first: gdalwarp -t_srs CRS -r cubic " +
                    in_command(terrain.paths) + " projected.tif");
  if (view.file) return std::nullopt;
  return GroundOrigin{given_place(view, terrain).value_or(map_bounds(terrain).centre()),
                      exaggeration_of(view, box)};
}

void stand_in(TerrainData& terrain, const Box3& box, const std::optional<GroundOrigin>& origin,
              const ViewSpec& view) {
  if (origin)
    reframe_at(terrain, *origin);
  else
    stand_below_eye(terrain, *view.file, exaggeration_of(view, box));
  limit_lean(std::get<Grid>(terrain.surface));
}

} // namespace

void stand_on_earth(TerrainData& terrain, const ViewSpec& view) {
  if (!terrain.map.earth) return;
  const Box3 box = true_box(terrain);
  stand_in(terrain, box, ground_origin(terrain, box, view), view);
}

const TerrainFacts& TerrainInFrame::facts() {
  // Waiting can be stopped as well.
  constexpr std::chrono::milliseconds kPatience{10};
  std::unique_lock lock(mutex_);
  while (are_sought_) {
    sought_.wait_for(lock, kPatience);
    throw_if_stopped();
  }
  if (facts_) return *facts_;
  are_sought_ = true;
  lock.unlock();
  const auto end_search = [&](std::shared_ptr<const TerrainFacts> found) {
    lock.lock();
    are_sought_ = false;
    facts_ = std::move(found);
    sought_.notify_all();
  };
  try {
    end_search(std::make_shared<const TerrainFacts>(facts_of(*terrain_)));
  } catch (...) {
    end_search(nullptr);
    throw;
  }
  return *facts_;
}

std::shared_ptr<const MadeLevel> TerrainInFrame::level_of_step(double step) const {
  const std::lock_guard lock(mutex_);
  return made_ && made_->step == step ? made_ : nullptr;
}

void TerrainInFrame::keep(std::shared_ptr<const MadeLevel> made) {
  const std::lock_guard lock(mutex_);
  made_ = std::move(made);
}

std::shared_ptr<TerrainInFrame> TerrainForViews::in_frame_of(const ViewSpec& view) {
  if (!whole_->map.earth) return on_plane_;
  Box3 box;
  std::optional<GroundOrigin> origin;
  {
    const std::lock_guard lock(mutex_);
    if (!true_box_) true_box_ = true_box(*whole_);
    box = *true_box_;
    origin = ground_origin(*whole_, box, view);
    if (origin && origin == last_origin_) return last_on_earth_;
  }
  auto framed = std::make_shared<TerrainData>(*whole_);
  stand_in(*framed, box, origin, view);
  auto made = std::make_shared<TerrainInFrame>(std::move(framed));
  const std::lock_guard lock(mutex_);
  if (!origin) return made;
  last_origin_ = origin;
  last_on_earth_ = made;
  return made;
}

} // namespace orograph
