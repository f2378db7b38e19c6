// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/scene.hpp"

#include "cli/geodesy.hpp"
#include "cli/place_eye.hpp"
#include "cli/scene_view.hpp"
#include "cli/solids/solids_of_view.hpp"
#include "cli/solids/stand_solids.hpp"
#include "dem/height_at.hpp"
#include "geometry/error.hpp"
#include "profiles/cut_surface.hpp"
#include "profiles/line_places.hpp"
#include "profiles/plan.hpp"
#include "view/place_phigs_view.hpp"
#include "view/place_view.hpp"
#include "view/profile_frame.hpp"
#include "view/sectors.hpp"
#include "view/visibility_homography.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace orograph {
namespace {

// Pen widths between profiles that read well on real terrain (docs/how-it-works.md).
constexpr double kPenWidthsApart = 4;

ViewRequest view_request(const RenderSettings& settings, const Terrain& terrain,
                         double exaggeration) {
  ViewRequest request;
  request.projection = settings.projection;
  request.oblique = settings.oblique;
  request.from_azimuth = settings.from_azimuth;
  request.from_elevation = settings.from_elevation;
  request.field_of_view = settings.field_of_view;
  request.distance_m = settings.distance_m;
  request.roll = settings.roll;
  request.exaggeration = exaggeration;
  place_eye(request, settings, terrain);
  return request;
}

// Height over width of the picture where the page decides it: the page lies unless told otherwise.
double page_aspect(PageRequest request) {
  if (request.orientation == Orientation::by_picture) request.orientation = Orientation::landscape;
  const Box2 inner = place_on_page({{0, 0}, {1, 1}}, request).page.inner_mm();
  return inner.height() / inner.width();
}

// Of the ground under a perspective view's eye, exaggerated.
std::optional<double> ground_under_eye(const View& view, const Surface& surface) {
  if (!view.is_perspective()) return std::nullopt;
  const auto height = height_at(surface, view.depth_origin_m);
  return height ? std::optional(*height * view.exaggeration) : std::nullopt;
}

void check_eye(const View& view, double ground_z_m, const MapFrame& map) {
  // On the ground itself, but for rounding, is not under it.
  constexpr double kRounding = 8 * std::numeric_limits<double>::epsilon();
  if (view.eye_z_m >= ground_z_m - kRounding * std::abs(ground_z_m)) return;
  const auto height = [&](double z_m) {
    const Vec2 at = view.depth_origin_m;
    return map.to_map({at.x, at.y, z_m / view.exaggeration}).z;
  };
  throw Error(
      fmt::format("the eye, at height {:.6g}, is under the ground, which is at {:.6g} there",
                  height(view.eye_z_m), height(ground_z_m)),
      "raise the eye, or move it");
}

std::vector<BorderEdge> border_of(const Grid& grid, const SurfaceExtent& extent) {
  return border_edges(grid, extent.valid == grid.size());
}
std::vector<BorderEdge> border_of(const Tin& tin, const SurfaceExtent&) {
  return border_edges(tin);
}

void place_view_file(Scene& scene, const ViewFile& file, const MapFrame& map, double exaggeration,
                     const EarthDrop& drop) {
  const PhigsView phigs = phigs_view(file, map, exaggeration);
  scene.view = place_phigs_view(phigs, exaggeration, scene.cell_m, drop);
  if (!file.cuts()) return;
  const auto [per_u, per_v, per_z, at_origin] = volume_depth(phigs, frame_of(phigs));
  scene.depth = VolumeDepth{per_u, per_v, per_z, at_origin};
}

// Those between which the terrain lies. A TIN's are its vertices': its cutter has more to make.
void find_depths(Scene& scene, const Surface& surface) {
  if (const Tin* tin = std::get_if<Tin>(&surface)) {
    scene.nearest_m = std::numeric_limits<double>::infinity();
    scene.farthest_m = -scene.nearest_m;
    for (const Vec3& vertex : tin->vertices_m) {
      const double depth_m = to_profile_frame(scene.view, vertex).v;
      scene.nearest_m = std::min(scene.nearest_m, depth_m);
      scene.farthest_m = std::max(scene.farthest_m, depth_m);
    }
    return;
  }
  const SurfaceCutter cutter(surface, scene.view, scene.level.triangles, scene.border);
  scene.nearest_m = cutter.nearest_m();
  scene.farthest_m = cutter.farthest_m();
}

// View and page, on ground that sinks by `drop`.
void place_on_earth(Scene& scene, const Terrain& terrain, const RenderSettings& settings,
                    const TerrainShape& shape, double exaggeration, const EarthDrop& drop) {
  if (settings.view) {
    place_view_file(scene, *settings.view, terrain.map, exaggeration, drop);
  } else {
    ViewRequest request = view_request(settings, terrain, exaggeration);
    request.drop = drop;
    scene.view = place_view(request, shape, page_aspect(settings.page));
  }
  const Placement placement = place_on_page(scene.view.window, settings.page);
  scene.page = placement.page;
  scene.to_page = compose(placement.to_page, scene.view.to_picture);
  scene.frame_mm = scene.page.inner_mm();
  if (settings.view) { // of which the window is all that is shown
    const Vec2 low = placement.to_page(scene.view.window.low),
               high = placement.to_page(scene.view.window.high);
    scene.frame_mm = {{low.x, high.y}, {high.x, low.y}};
  }
}

// With the eye on the ground itself there is no seam to be seen between two sectors: all ground
// under it is seen edge-on. The narrow strip's near cut would be a matter of rounding.
void keep_off_the_ground(View& view, double ground_z_m, double cell_m) {
  if (shows_beside(view) && view.eye_z_m < ground_z_m + 1e-6 * cell_m)
    view.near_m = kNearShareOfCell * cell_m;
}

// What the page shows: of a page with nothing but what lies at the eye's feet, no more than three
// cells away, the ground's height there, and what it may rise or fall so far, at 45 degrees. The
// terrain's mean height, hundreds of metres below, says nothing of it.
PlanGround plan_ground(const Scene& scene, std::optional<double> under_eye_m) {
  const View& view = scene.view;
  const Box3& box = scene.extent.box;
  PlanGround ground{scene.nearest_m, scene.farthest_m,
                    scene.extent.mean_height_m * view.exaggeration,
                    (box.high.z - box.low.z) * view.exaggeration};
  if (view.frames_terrain || !under_eye_m) return ground;
  double farthest_m = 0;
  for (const Vec3& ray : corner_rays(view)) {
    if (!(ray.y < 0)) return ground;
    farthest_m =
        std::max(farthest_m, (view.eye_z_m - *under_eye_m) * std::hypot(ray.x, ray.z) / -ray.y);
  }
  if (farthest_m > 0 && farthest_m <= 3 * scene.cell_m) {
    ground.mean_z_m = *under_eye_m;
    ground.relief_m = farthest_m;
  }
  return ground;
}

// Where it would show, unless told otherwise. A parallel view is a picture of the map plane, and so
// are planes that cut the terrain. On the ellipsoid there is refraction left to draw.
bool draws_drop(const Terrain& terrain, const Scene& scene, const RenderSettings& settings) {
  const bool is_left = !terrain.map.earth || scene.curvature.refraction != 0;
  if (settings.curvature != Curvature::automatic)
    return settings.curvature == Curvature::on && is_left;
  const bool cut = settings.view && settings.view->cuts();
  return is_left && scene.view.is_perspective() && terrain.map.radii && !cut &&
         scene.curvature.would_move_mm > settings.simplify_mm + kPageStep_mm;
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

// A scene without ground is as large as its solids. What is smaller than a hundredth of it doesn't
// matter for where its near plane is.
void take_extent(Scene& scene, const BlockedPoints& points) {
  Box3& extent = scene.extent.box;
  for (const Box3& box : points.boxes) {
    extent.include(box.low);
    extent.include(box.high);
  }
  scene.extent.mean_height_m = extent.centre().z;
  scene.cell_m = 0.01 * length(extent.high - extent.low);
}

// Those of the two sides of the eye on which there is something.
std::vector<Sector> sectors_of(const Scene& scene) {
  Sector ahead;
  ahead.view = scene.view;
  ahead.to_page = scene.to_page;
  ahead.nearest_m = scene.nearest_m;
  ahead.farthest_m = scene.farthest_m;
  std::vector<Sector> sectors{ahead};
  double nearest_m = scene.nearest_m;
  for (const StandingSolid& solid : scene.solids)
    for (const Vec3& vertex : solid.vertices_m)
      nearest_m = std::min(nearest_m, to_profile_frame(scene.view, vertex).v);
  if (shows_beside(scene.view) && nearest_m < -scene.view.near_m) {
    Sector behind;
    behind.behind = true;
    behind.view = sector_behind(scene.view);
    behind.to_page = homography_behind(scene.to_page);
    behind.nearest_m = -scene.farthest_m;
    behind.farthest_m = -scene.nearest_m;
    sectors.push_back(behind);
    sectors.front().keeps_strip = scene.view.near_m < kNearShareOfCell * scene.cell_m;
  }
  for (Sector& sector : sectors) {
    for (std::size_t i = 0; i < scene.depths_m.size(); ++i) {
      const double depth = sector.behind ? -scene.depths_m[i] : scene.depths_m[i];
      if (sectors.size() == 1 || depth > 0)
        sector.profiles.push_back({depth, static_cast<std::int32_t>(i)});
    }
    if (sector.behind) std::reverse(sector.profiles.begin(), sector.profiles.end());
  }
  return sectors;
}

} // namespace

double chosen_exaggeration(const Box3& terrain) {
  const Vec3 size = terrain.high - terrain.low;
  const double steepness = size.z / std::max(size.x, size.y);
  return steepness >= 0.12 ? 1 : steepness >= 0.06 ? 1.5 : 2;
}

double exaggeration_of(const RenderSettings& settings, const Box3& terrain) {
  if (settings.exaggeration) return *settings.exaggeration;
  if (settings.view) return settings.view->exaggeration;
  return settings.has_eye() || terrain.empty() ? 1 : chosen_exaggeration(terrain);
}

TerrainFacts facts_of(const Terrain& terrain, FlatGround flat) {
  const Surface& surface = terrain.surface;
  TerrainFacts facts;
  if (!has_ground(surface)) return facts;
  facts.extent = extent_of(surface);
  facts.cell_m = cell_size_m(surface);
  facts.border = std::visit([&](const auto& s) { return border_of(s, facts.extent); }, surface);
  facts.outline = std::visit([&](const auto& s) { return outline_of(s, facts.border); }, surface);
  if (flat == FlatGround::shore)
    facts.water = std::visit([](const auto& s) { return find_water(s); }, surface);
  return facts;
}

Scene place_scene(const Terrain& terrain, const RenderSettings& settings, const Terrain* uncut) {
  return place_scene(terrain, facts_of(terrain, settings.flat), settings, uncut);
}

Scene place_scene(const Terrain& terrain, TerrainFacts facts, const RenderSettings& settings,
                  const Terrain* uncut) {
  const Surface& surface = terrain.surface;
  Scene scene;
  scene.extent = std::move(facts.extent);
  scene.cell_m = facts.cell_m;
  scene.border = std::move(facts.border);
  scene.level = std::move(facts.water);

  const bool on_ground = has_ground(surface);
  scene.exaggeration_chosen = on_ground && !settings.exaggeration && !settings.view;
  const std::optional<EarthFrame>& earth = terrain.map.earth;
  scene.exaggeration = earth ? earth->exaggeration : exaggeration_of(settings, scene.extent.box);
  // On the ellipsoid heights went to their place exaggerated.
  const double exaggeration = earth ? 1 : scene.exaggeration;
  if (settings.solids) {
    scene.solids = stand_solids(*settings.solids, uncut ? *uncut : terrain);
    if (settings.view && settings.view->cuts())
      leave_out_cut(scene.solids, *settings.solids, *settings.view, terrain.map, exaggeration);
  }
  BlockedPoints beside = points_of(scene.solids);
  if (!on_ground) take_extent(scene, beside);
  const TerrainShape shape{scene.extent.blocks,        facts.outline, scene.extent.box,
                           scene.extent.mean_height_m, scene.cell_m,  std::move(beside)};
  const auto place = [&](const EarthDrop& drop) {
    place_on_earth(scene, terrain, settings, shape, exaggeration, drop);
  };
  place({});
  SceneCurvature& curvature = scene.curvature;
  curvature.refraction = scene.view.is_perspective() ? settings.refraction : 0;
  curvature.radii =
      terrain.map.radii.value_or(CurvatureRadii{kMeanEarthRadius_m, kMeanEarthRadius_m});
  const EarthDrop drop = earth_drop(terrain.map, curvature.refraction);
  curvature.would_move_mm = drop_mm(scene, drop);
  const bool has_drop = draws_drop(terrain, scene, settings);
  if (has_drop) place(drop);
  curvature.on_ellipsoid = earth.has_value();
  curvature.applied = earth || has_drop;
  if (earth && !has_drop) curvature.refraction = 0;
  if (settings.solids) check_eye_outside(scene.solids, *settings.solids, scene.view);
  const std::optional<double> under_eye_m = ground_under_eye(scene.view, surface);
  if (under_eye_m) {
    check_eye(scene.view, *under_eye_m, terrain.map);
    keep_off_the_ground(scene.view, *under_eye_m, scene.cell_m);
  }

  scene.plan = settings.plan.value_or(PageSpacing{kPenWidthsApart * settings.pen_width_mm});
  if (!on_ground) {
    scene.sectors = sectors_of(scene);
    return scene;
  }
  find_depths(scene, surface);
  PlanGround ground = plan_ground(scene, under_eye_m);
  if (const Grid* grid = std::get_if<Grid>(&surface))
    ground.row_depths_m = row_depths(*grid, scene.view);
  scene.depths_m = plan_depths(scene.plan, ground, scene.view, scene.to_page);
  scene.sectors = sectors_of(scene);
  return scene;
}

} // namespace orograph
