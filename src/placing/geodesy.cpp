// SPDX-License-Identifier: GPL-3.0-or-later
#include "placing/geodesy.hpp"

#include "dem/frame/local_frame.hpp"
#include "dem/read/lonlat.hpp"
#include "view/sectors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace orograph {
namespace {

// Of the terrain, from where depth is 0: least and greatest horizontal distance.
struct Distances {
  double nearest_m, farthest_m;
};
Distances distances(const PlacedView& placed) {
  const auto& [low, high] = placed.extent.box;
  const Vec2 at = placed.view.depth_origin_m;
  const double aside_x = std::max({low.x - at.x, at.x - high.x, 0.0}),
               aside_y = std::max({low.y - at.y, at.y - high.y, 0.0});
  return {std::hypot(aside_x, aside_y),
          std::hypot(std::max(at.x - low.x, high.x - at.x), std::max(at.y - low.y, high.y - at.y))};
}

// Of the map plane, as seen from the eye: the greatest error of direction, in radians, and between
// which shares distances are too long.
struct MapErrors {
  double turn = 0, least_stretch = 0, most_stretch = 0;
};
std::optional<MapErrors> map_errors(const PlacedView& placed, const MapFrame& map) {
  const auto lonlat = [&](Vec2 ground_m) -> std::optional<GeoPoint> {
    const Vec3 at = map.to_map({ground_m.x, ground_m.y, 0});
    const auto found = lonlat_of_map(map.crs_wkt, {at.x, at.y});
    if (!found) return std::nullopt;
    return GeoPoint{found->x, found->y, 0};
  };
  MapErrors errors;
  const Vec2 eye_m = placed.view.depth_origin_m;
  const auto eye = lonlat(eye_m);
  if (!eye) return std::nullopt;
  const Vec3 eye_map = map.to_map({eye_m.x, eye_m.y, 0});
  const auto& [low, high] = placed.extent.box;
  double least = std::numeric_limits<double>::infinity(), most = -least;
  for (const double x : {low.x, 0.5 * (low.x + high.x), high.x})
    for (const double y : {low.y, 0.5 * (low.y + high.y), high.y}) {
      const Vec2 away = Vec2{x, y} - eye_m;
      const auto ground = lonlat({x, y});
      const auto towards =
          true_azimuth(map.crs_wkt, {eye_map.x, eye_map.y}, atan2_angle(away.x, away.y));
      if (!ground || !towards) return std::nullopt;
      if (!(length(away) > 1)) continue;
      const auto [distance_m, azimuth] = distance_and_azimuth(*eye, *ground);
      const double turn =
          std::remainder(azimuth.in_radians() - towards->in_radians(), 2 * std::numbers::pi);
      errors.turn = std::max(errors.turn, std::abs(turn));
      const double stretch = length(away) / distance_m - 1;
      // Up where the ground is, the earth is wider.
      least = std::min(least, stretch - high.z / kMeanEarthRadius_m);
      most = std::max(most, stretch - low.z / kMeanEarthRadius_m);
    }
  if (least <= most) {
    errors.least_stretch = least;
    errors.most_stretch = most;
  }
  return errors;
}

} // namespace

EarthDrop earth_drop(const MapFrame& map, double refraction) {
  if (map.earth) {
    const LocalFrame& frame = map.earth->local;
    const double lift = refraction / (2 * mean_radius_m(frame.ellipsoid(), frame.origin_lat_deg()));
    return {-lift, -lift};
  }
  const auto [meridian_m, prime_vertical_m] =
      map.radii.value_or(CurvatureRadii{kMeanEarthRadius_m, kMeanEarthRadius_m});
  return {(1 - refraction) / (2 * meridian_m), (1 - refraction) / (2 * prime_vertical_m)};
}

double mm_per_height(const PlacedView& placed, Vec3 ray) {
  return placed.to_page.mm_per_step(ray, {0, 1, 0}) *
         (placed.view.is_perspective() ? 1 : placed.view.y_per_z);
}

std::vector<Vec3> shown_rays(const View& view) {
  constexpr int kSteps = 4;
  std::vector<Vec3> rays;
  for (int i = 0; i <= kSteps; ++i)
    for (int k = 0; k <= kSteps; ++k)
      rays.push_back(ray_of_picture(view, {view.window.low.x + view.window.width() * i / kSteps,
                                           view.window.low.y + view.window.height() * k / kSteps}));
  return rays;
}

double drop_mm(const PlacedView& placed, const EarthDrop& drop) {
  const auto [nearest, farthest] = distances(placed);
  const double per_m2 = std::max(std::abs(drop.per_north), std::abs(drop.per_east));
  double greatest = 0;
  for (const Vec3& ray : shown_rays(placed.view)) {
    // A perspective ray with ground at a horizontal distance is as many times as long.
    const double moved = placed.view.is_perspective()
                             ? std::hypot(ray.x, ray.z) * (farthest - nearest)
                             : farthest * farthest;
    greatest = std::max(greatest, mm_per_height(placed, ray) * per_m2 * moved);
  }
  return greatest;
}

std::optional<double> map_plane_mm(const PlacedView& placed, const MapFrame& map,
                                   bool eye_is_given) {
  const auto found = map_errors(placed, map);
  if (!found) return std::nullopt;
  const MapErrors& errors = *found;
  const double stretch =
      eye_is_given ? std::max(std::abs(errors.least_stretch), std::abs(errors.most_stretch))
                   : 0.5 * (errors.most_stretch - errors.least_stretch);
  const double farthest = distances(placed).farthest_m;
  double greatest = 0;
  for (const Vec3& ray : shown_rays(placed.view)) {
    const bool perspective = placed.view.is_perspective();
    // Turned, ground moves aside; stretched, it seems higher or lower against the eye's level.
    const double aside = (perspective ? std::hypot(ray.x, ray.z) : farthest) * errors.turn;
    const double up = (perspective ? std::abs(ray.y) : farthest) * stretch;
    greatest = std::max(greatest, std::hypot(placed.to_page.mm_per_step(ray, {1, 0, 0}) * aside,
                                             mm_per_height(placed, ray) * up));
  }
  return greatest;
}

double least_distance_m(const PlacedView& placed) {
  const View& view = placed.view;
  double least = std::numeric_limits<double>::infinity();
  for (const Box3& box : placed.extent.blocks.boxes) {
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

double sag_mm(const PlacedView& placed, const EarthDrop& drop, double longest_edge_m) {
  const double per_m2 = std::max(std::abs(drop.per_north), std::abs(drop.per_east));
  const double sag_m = per_m2 * longest_edge_m * longest_edge_m / 4;
  const bool perspective = placed.view.is_perspective();
  const double nearest_m = perspective ? least_distance_m(placed) : 1;
  double greatest = 0;
  for (const Vec3& ray : shown_rays(placed.view))
    greatest = std::max(greatest, mm_per_height(placed, ray) *
                                      (perspective ? length(ray) / nearest_m * sag_m : sag_m));
  return greatest;
}

double parabola_mm(const PlacedView& placed) {
  const double d = distances(placed).farthest_m / kMeanEarthRadius_m;
  double greatest = 0;
  for (const Vec3& ray : shown_rays(placed.view)) {
    const bool perspective = placed.view.is_perspective();
    const double level = perspective ? std::hypot(ray.x, ray.z) : d * kMeanEarthRadius_m;
    const double up = level * d * d * d / 8 + (perspective ? std::abs(ray.y) : 0) * d * d / 6;
    greatest = std::max(greatest, mm_per_height(placed, ray) * up);
  }
  return greatest;
}

} // namespace orograph
