// SPDX-License-Identifier: GPL-3.0-or-later
#include "placing/observer.hpp"

#include "dem/height_at.hpp"
#include "geometry/error.hpp"
#include "placing/geodesy.hpp"
#include "placing/places.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace orograph {
namespace {

constexpr Vec2 kNorth{0, 1};

View looking_north(Vec2 at_m, double eye_z_m, double exaggeration, const EarthDrop& drop) {
  View view;
  view.forward = kNorth;
  view.right = {1, 0};
  view.depth_origin_m = at_m;
  view.eye_z_m = eye_z_m;
  view.exaggeration = exaggeration;
  view.drop = drop_in_frame(drop, kNorth);
  return view;
}

} // namespace

Observer observer_of(const ViewSpec& view, const TerrainData& terrain) {
  const bool on_earth = terrain.map.earth.has_value();
  ViewRequest request; // on the ellipsoid heights went to their place exaggerated
  request.exaggeration = on_earth ? 1 : view.exaggeration.value_or(1);
  place_eye(request, view, terrain);
  const Vec3 eye = *request.eye_m;
  Observer out;
  out.curvature = view.curvature == Curvature::on ||
                  (view.curvature == Curvature::automatic && (on_earth || terrain.map.radii));
  const EarthDrop drop = out.curvature ? earth_drop(terrain.map, view.refraction) : EarthDrop{};
  out.view =
      looking_north({eye.x, eye.y}, eye.z * request.exaggeration, request.exaggeration, drop);
  if (const auto ground = height_at(terrain.surface, out.view.depth_origin_m))
    check_above_ground(out.view, *ground * request.exaggeration, terrain.map);
  return out;
}

Observer observer_of(const PlacedView& placed, const MapFrame& map) {
  const View& view = placed.view;
  const EarthDrop drop =
      placed.curvature.applied ? earth_drop(map, placed.curvature.refraction) : EarthDrop{};
  return {looking_north(view.depth_origin_m, view.eye_z_m, view.exaggeration, drop),
          placed.curvature.applied};
}

void check_above_ground(const View& view, double ground_z_m, const MapFrame& map) {
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
      "raise the eye, move it, or give `underside`, to see the ground from below");
}

} // namespace orograph
