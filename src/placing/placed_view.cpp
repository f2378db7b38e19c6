// SPDX-License-Identifier: GPL-3.0-or-later
#include "placing/placed_view.hpp"

#include "dem/height_at.hpp"
#include "draw/page.hpp"
#include "geometry/error.hpp"
#include "geometry/on_all_cores.hpp"
#include "placing/block.hpp"
#include "placing/frame_eye_view.hpp"
#include "placing/furniture_room.hpp"
#include "placing/geodesy.hpp"
#include "placing/give_tone.hpp"
#include "placing/observer.hpp"
#include "placing/place_sectors.hpp"
#include "placing/placed_solids.hpp"
#include "placing/places.hpp"
#include "placing/view_in_frame.hpp"
#include "profiles/cut_surface.hpp"
#include "profiles/grid_lines.hpp"
#include "profiles/plan.hpp"
#include "view/phigs_view.hpp"
#include "view/place_view.hpp"
#include "view/sectors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

namespace orograph {
namespace {

ViewRequest view_request(const MapSpec& spec, const TerrainData& terrain, double exaggeration) {
  ViewRequest request;
  request.projection =
      is_panorama(spec.view.projection) ? Projection::perspective : spec.view.projection;
  request.oblique = spec.view.oblique;
  request.field_of_view = spec.view.field_of_view;
  request.distance_m = spec.view.distance_m;
  request.roll = spec.view.roll;
  request.elevation_above = spec.view.elevation_above;
  request.exaggeration = exaggeration;
  request.both_sides = spec.style.underside == Underside::draw;
  place_eye(request, spec.view, terrain);
  return request;
}

// Height over width of the picture where the page decides it: the page lies unless told otherwise,
// as an A4 does where it has no height.
double page_aspect(PageRequest request) {
  if (!request.height_mm) return std::numbers::sqrt2 / 2;
  if (request.orientation == Orientation::by_picture) request.orientation = Orientation::landscape;
  request.crop = false;
  request.scale.reset();
  const Box2 room = place_on_page({{0, 0}, {1, 1}}, request).room_mm;
  return room.height() / room.width();
}

WindowShape window_shape(const PageRequest& request) {
  constexpr double kSquare = 1; // no foreground is worth more
  return {request.height_mm ? page_aspect(request) : kSquare, request.ends_with_picture()};
}

// Of the ground under a perspective view's eye, exaggerated.
std::optional<double> ground_under_eye(const View& view, const Surface& surface) {
  if (!view.is_perspective()) return std::nullopt;
  const auto height = height_at(surface, view.depth_origin_m);
  return height ? std::optional(*height * view.exaggeration) : std::nullopt;
}

void place_view_file(PlacedView& placed, const ViewFile& file, const MapFrame& map,
                     double exaggeration, const EarthDrop& drop) {
  const PhigsView phigs = phigs_view(file, map, exaggeration);
  placed.view = place_phigs_view(phigs, exaggeration, placed.cell_m, drop);
  if (!file.cuts()) return;
  const auto [per_u, per_v, per_z, at_origin] = volume_depth(phigs, frame_of(phigs));
  placed.depth = VolumeDepth{per_u, per_v, per_z, at_origin};
}

// Level, towards the terrain's centre where nothing says otherwise; north from straight above it.
LookDirection level_look(const ViewRequest& request, const TerrainShape& shape) {
  if (request.look) return *request.look;
  const Vec3 towards = request.look_at_m.value_or(shape.box.centre()) - *request.eye_m;
  if (towards.x == 0 && towards.y == 0) return {};
  return {atan2_angle(towards.x, towards.y), Angle()};
}

CutSurface cut_surface(const PlacedView& placed, const Surface& surface) {
  return {surface, placed.level.triangles, placed.for_cutters, &placed.extent.box};
}

std::vector<GroundAhead> ground_ahead_of(const PlacedView& placed, const Surface& surface,
                                         const EarthDrop& drop) {
  if (placed.panorama)
    return ground_about(*placed.panorama, placed.view, cut_surface(placed, surface));
  constexpr int kColumns = 17;
  return ground_ahead(placed.view, drop, cut_surface(placed, surface), kColumns);
}

std::optional<ChosenView> chosen_view(const PlacedView& placed, const Surface& surface,
                                      const ViewSpec& view, double exaggeration) {
  if (!view.from_auto || view.file || view.has_eye()) return std::nullopt;
  if (!has_ground(surface))
    throw UsageError("without a terrain there is no view to choose", "give `from_azimuth`");
  if (view.projection == Projection::oblique)
    throw UsageError("an oblique view has an elevation of its own, so none can be chosen",
                     "give `from_azimuth`, or ask for another `projection`");
  return choose_view(
      coarse_ground(cut_surface(placed, surface), placed.extent.box, placed.cell_m, exaggeration));
}

// Whether it is so framed; else the view is to be placed as asked.
bool frame_by_skyline(PlacedView& placed, const TerrainData& terrain, const MapSpec& spec,
                      const TerrainShape& shape, ViewRequest request) {
  if (!has_ground(terrain.surface) || !is_framed_by_skyline(spec.view)) return false;
  request.look = level_look(request, shape);
  placed.view = place_view(request, shape, page_aspect(spec.page));
  const std::optional<double> under_eye_m = ground_under_eye(placed.view, terrain.surface);
  if (under_eye_m && placed.view.eye_z_m < *under_eye_m) return false; // which has no skyline
  const bool over_ground = under_eye_m.has_value();
  return frame_eye_view(placed.view, shape, ground_ahead_of(placed, terrain.surface, request.drop),
                        over_ground, window_shape(spec.page));
}

// The eye, the directions and the page of a panorama.
void place_panorama(PlacedView& placed, const TerrainData& terrain, const MapSpec& spec,
                    const TerrainShape& shape, double exaggeration, const EarthDrop& drop) {
  MapSpec looking = spec;
  looking.view = looking_to_middle(spec.view);
  ViewRequest request = view_request(looking, terrain, exaggeration);
  request.drop = drop;
  request.look = level_look(request, shape);
  Panorama panorama = panorama_asked(spec.view, request);
  View& view = placed.view;
  view = level_view(request, placed.cell_m);
  std::vector<GroundAhead> about;
  if (has_ground(terrain.surface))
    about = ground_about(panorama, view, cut_surface(placed, terrain.surface));
  frame_panorama(panorama, view, shape, about, ground_under_eye(view, terrain.surface).has_value(),
                 spec.view.altitude_range, spec.page);
  placed.page = place_panorama_on_page(panorama, view, spec.page);
  placed.frame_mm = panorama.frame_mm;
  placed.room_mm = panorama.strips_mm();
  const std::vector<Sector> sectors = sectors_of(panorama, view);
  view.window = sectors[sectors.size() / 2].view.window;
  const PanoramaPage& page = panorama.page;
  placed.to_page = {
      {page.radius_mm, 0, page.ahead_mm.x, 0, -page.radius_mm, page.ahead_mm.y, 0, 0, 1}};
  placed.panorama = std::move(panorama);
}

// View and page, on ground that sinks by `drop`.
void place_on_earth(PlacedView& placed, const TerrainData& terrain, const MapSpec& spec,
                    const TerrainShape& shape, double exaggeration, const EarthDrop& drop) {
  if (!spec.view.file && is_panorama(spec.view.projection)) {
    place_panorama(placed, terrain, spec, shape, exaggeration, drop);
    return;
  }
  if (spec.view.file) {
    place_view_file(placed, *spec.view.file, terrain.map, exaggeration, drop);
    if (placed.view.y_per_v < 0 && spec.style.underside == Underside::omit)
      throw Error("a parallel view that looks up shows the underside alone",
                  "put the PRP higher, so that the direction from it to the window's centre "
                  "descends, or give `underside`");
  } else {
    ViewRequest request = view_request(spec, terrain, exaggeration);
    const auto& chosen = placed.chosen_view;
    request.from_azimuth = chosen ? chosen->azimuth : spec.view.from_azimuth;
    request.from_elevation = chosen ? chosen->elevation : spec.view.from_elevation;
    request.drop = drop;
    placed.framed_by_skyline = frame_by_skyline(placed, terrain, spec, shape, request);
    if (!placed.framed_by_skyline) placed.view = place_view(request, shape, page_aspect(spec.page));
  }
  if (spec.page.scale && placed.view.is_perspective())
    throw UsageError("`scale` has no meaning in perspective, where what is near is larger",
                     "ask for an orthographic or an oblique `projection`");
  const Placement placement = place_on_page(placed.view.window, spec.page);
  placed.page = placement.page;
  placed.to_page = compose(placement.to_page, placed.view.to_picture);
  placed.room_mm = placed.frame_mm = placement.room_mm;
  // A view in a file shows no more than its window. Where that doesn't reach to the margins, or the
  // page is made to its measure, a view is to be the same when it comes back as a file.
  if (spec.view.file || spec.page.scale ||
      (placed.framed_by_skyline && spec.page.ends_with_picture())) {
    const Vec2 low = placement.to_page(placed.view.window.low),
               high = placement.to_page(placed.view.window.high);
    placed.frame_mm = {{low.x, high.y}, {high.x, low.y}};
  }
}

// With the eye on the ground itself there is no seam to be seen between two sectors: all ground
// under it is seen edge-on. The narrow strip's near cut would be a matter of rounding.
void keep_off_the_ground(View& view, double ground_z_m, double cell_m) {
  if (shows_beside(view) && std::abs(view.eye_z_m - ground_z_m) < 1e-6 * cell_m)
    view.near_m = kNearShareOfCell * cell_m;
}

// What the page shows: of a page with nothing but what lies at the eye's feet, no more than three
// cells away, the ground's height there, and what it may rise or fall so far, at 45 degrees. The
// terrain's mean height, hundreds of metres below, says nothing of it.
PlanGround plan_ground(const PlacedView& placed, std::optional<double> under_eye_m) {
  const View& view = placed.view;
  const Box3& box = placed.extent.box;
  PlanGround ground{placed.nearest_m, placed.farthest_m,
                    placed.extent.mean_height_m * view.exaggeration,
                    (box.high.z - box.low.z) * view.exaggeration};
  if (view.frames_terrain || !under_eye_m) return ground;
  double farthest_m = 0;
  for (const Vec3& ray : corner_rays(view)) {
    if (!(ray.y < 0)) return ground;
    farthest_m =
        std::max(farthest_m, (view.eye_z_m - *under_eye_m) * std::hypot(ray.x, ray.z) / -ray.y);
  }
  if (farthest_m > 0 && farthest_m <= 3 * placed.cell_m) {
    ground.mean_z_m = *under_eye_m;
    ground.relief_m = farthest_m;
  }
  return ground;
}

// Where it would show, unless told otherwise. A parallel view is a picture of the map plane, and so
// are planes that cut the terrain. On the ellipsoid there is refraction left to draw.
bool draws_drop(const TerrainData& terrain, const PlacedView& placed, const MapSpec& spec) {
  const bool is_left = !terrain.map.earth || placed.curvature.refraction != 0;
  if (spec.view.curvature != Curvature::automatic)
    return spec.view.curvature == Curvature::on && is_left;
  const bool cut = spec.view.file && spec.view.file->cuts();
  return is_left && placed.view.is_perspective() && terrain.map.radii && !cut &&
         placed.curvature.would_move_mm > spec.style.simplify_mm + kPageStep_mm;
}

// One block a solid. REQUIRES that they outlive it.
BlockedPoints points_of(const std::vector<StandingSolid>& solids) {
  BlockedPoints out;
  for (const StandingSolid& solid : solids) {
    Box3 box;
    for (const Vec3& vertex : solid.vertices_m) box.include(vertex);
    out.boxes.push_back(box);
  }
  out.points = [&solids](std::size_t i) { return std::span<const Vec3>(solids[i].vertices_m); };
  return out;
}

// Where there is no ground, the solids are all that there is. What is smaller than a hundredth of
// them doesn't matter for where the near plane is.
void take_extent(PlacedView& placed, const BlockedPoints& points) {
  Box3& extent = placed.extent.box;
  for (const Box3& box : points.boxes) {
    extent.include(box.low);
    extent.include(box.high);
  }
  placed.extent.mean_height_m = extent.centre().z;
  placed.cell_m = 0.01 * length(extent.high - extent.low);
}

struct Picture {
  PlacedView placed; ///< all but its lines
  std::optional<double> under_eye_m;
};

Picture place_picture(const TerrainData& terrain, TerrainFacts facts, const MapSpec& asked,
                      const SceneFile* solids, const TerrainData& uncut) {
  MapSpec spec = asked;
  spec.page = page_with_room(asked);
  const Surface& surface = terrain.surface;
  PlacedView placed;
  placed.extent = std::move(facts.extent);
  placed.cell_m = facts.cell_m;
  placed.reach_m = facts.reach_m;
  placed.border = std::move(facts.border);
  placed.for_cutters = std::move(facts.for_cutters);
  placed.level = std::move(facts.water);

  const bool on_ground = has_ground(surface);
  // From an eye the page shows a part of each profile, and so does each sector of a panorama.
  if (const Tin* tin = std::get_if<Tin>(&surface);
      tin && on_ground && spec.view.has_eye() && !placed.for_cutters.tin_index)
    placed.for_cutters.tin_index = std::make_shared<const TinIndex>(*tin);
  placed.exaggeration_chosen = on_ground && !spec.view.exaggeration && !spec.view.file;
  const std::optional<EarthFrame>& earth = terrain.map.earth;
  placed.exaggeration = earth ? earth->exaggeration : exaggeration_of(spec.view, placed.extent.box);
  // On the ellipsoid heights went to their place exaggerated.
  const double exaggeration = earth ? 1 : placed.exaggeration;
  if (solids) {
    placed.solids = stand_solids(*solids, uncut);
    if (spec.view.file && spec.view.file->cuts())
      leave_out_cut(placed.solids, *solids, *spec.view.file, terrain.map, exaggeration);
  }
  BlockedPoints beside = points_of(placed.solids);
  if (!on_ground) take_extent(placed, beside);
  std::vector<Vec3> feet_m;
  if (spec.style.asks_for("block")) {
    placed.block_base_m = block_base_m(terrain, spec.style.block);
    feet_m = block_feet_m(terrain, placed.border, *placed.block_base_m);
    add_points(feet_m, beside);
  }
  const TerrainShape shape{placed.extent.blocks,        facts.outline, placed.extent.box,
                           placed.extent.mean_height_m, placed.cell_m, std::move(beside)};
  placed.chosen_view = chosen_view(placed, surface, spec.view, exaggeration);
  const auto place_with = [&](const EarthDrop& drop) {
    place_on_earth(placed, terrain, spec, shape, exaggeration, drop);
  };
  place_with({});
  EarthCurvature& curvature = placed.curvature;
  curvature.refraction = placed.view.is_perspective() ? spec.view.refraction : 0;
  curvature.radii =
      terrain.map.radii.value_or(CurvatureRadii{kMeanEarthRadius_m, kMeanEarthRadius_m});
  const EarthDrop drop = earth_drop(terrain.map, curvature.refraction);
  curvature.would_move_mm = drop_mm(placed, drop);
  const bool has_drop = draws_drop(terrain, placed, spec);
  if (has_drop) place_with(drop);
  curvature.on_ellipsoid = earth.has_value();
  curvature.applied = earth || has_drop;
  if (earth && !has_drop) curvature.refraction = 0;
  if (solids) check_eye_outside(placed.solids, *solids, placed.view);
  const std::optional<double> under_eye_m = ground_under_eye(placed.view, surface);
  if (under_eye_m) {
    if (spec.style.underside == Underside::omit)
      check_above_ground(placed.view, *under_eye_m, terrain.map);
    else if (placed.block_base_m && placed.view.is_perspective())
      check_outside_block(placed.view, *under_eye_m, *placed.block_base_m, terrain.map);
    keep_off_the_ground(placed.view, *under_eye_m, placed.cell_m);
    if (spec.view.has_eye() && placed.view.eye_z_m >= *under_eye_m)
      placed.near_skyline =
          near_skyline(placed.view, ground_ahead_of(placed, surface, has_drop ? drop : EarthDrop{}),
                       placed.cell_m, placed.view.eye_z_m - *under_eye_m);
  }
  return {std::move(placed), under_eye_m};
}

PlacedView place(const TerrainData& terrain, TerrainFacts facts, const MapSpec& spec,
                 const SceneFile* solids, const TerrainData& uncut) {
  const Surface& surface = terrain.surface;
  auto [placed, under_eye_m] = place_picture(terrain, std::move(facts), spec, solids, uncut);
  const bool on_ground = has_ground(surface);
  placed.plan = spec.style.plan.value_or(PageSpacing{kPenWidthsApart * spec.style.pen_width_mm});
  if (on_ground) {
    find_depths(placed, surface);
    PlanGround ground = plan_ground(placed, under_eye_m);
    if (const Grid* grid = std::get_if<Grid>(&surface); grid && !placed.panorama)
      ground.row_depths_m = row_depths(*grid, placed.view);
    placed.depths_m = plan_depths(placed.plan, ground, placed.view, placed.to_page);
  }
  place_sectors(placed);
  if (!on_ground) return placed;
  give_tone(placed, surface, spec); // which may need more profiles
  placed.ridge_shade = ridge_shade(placed, spec);
  return placed;
}

} // namespace

PlacedView placed_view(const TerrainData& terrain, const MapSpec& spec, const SceneFile* solids,
                       const TerrainData* uncut) {
  return place(terrain, facts_of(terrain), spec, solids, uncut ? *uncut : terrain);
}

PlacedView placed_view(const TerrainOfView& terrain, const MapSpec& spec, const SceneFile* solids) {
  if (const TerrainFacts* facts = terrain.facts()) {
    PlacedView out = place(*terrain, *facts, spec, solids, terrain.uncut());
    const bool has_patches = std::holds_alternative<Tin>(terrain->surface) &&
                             std::holds_alternative<Grid>(terrain.of_file().surface);
    if (has_patches) out.file = &terrain.of_file();
    return out;
  }
  return placed_view(*terrain, spec, solids, &terrain.uncut());
}

PlacedView placed_picture(const TerrainData& terrain, const TerrainFacts& facts,
                          const MapSpec& spec, const SceneFile* solids) {
  return place_picture(terrain, facts, spec, solids, terrain).placed;
}

} // namespace orograph
