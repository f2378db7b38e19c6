// SPDX-License-Identifier: GPL-3.0-or-later
#include "map/look_around.hpp"

#include "dem/extent.hpp"
#include "dem/frame/local_frame.hpp"
#include "dem/height_at.hpp"
#include "dem/read/lonlat.hpp"
#include "geometry/on_all_cores.hpp"
#include "placing/places.hpp"
#include "placing/terrain_facts.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace orograph {
namespace {

constexpr std::size_t kInTask = 64; // directions or places, some 10 microseconds each

double slope_deg(double slope) {
  return atan2_angle(slope, 1).in_degrees();
}

double in_turn(double azimuth_deg) {
  const double deg = azimuth_deg - 360 * std::floor(azimuth_deg / 360);
  return deg < 360 ? deg : 0;
}

// Part of what a call does: `before` of `all` looks are done already.
struct Share {
  std::size_t before, all;
  const std::function<void(double)>& progress;
};

// Calls take(i) for 0 to count - 1 on all cores, and tells the progress, where it is asked for,
// after every 4096 looks, some 20 ms.
template <class Take>
void for_each(std::size_t count, const Share& share, const Take& take) {
  const std::size_t in_part = share.progress ? 64 * kInTask : std::max<std::size_t>(count, 1);
  for (std::size_t from = 0; from < count; from += in_part) {
    const std::size_t to = std::min(count, from + in_part);
    on_all_cores((to - from + kInTask - 1) / kInTask, [&](std::size_t task) {
      const std::size_t begin = from + task * kInTask;
      for (std::size_t i = begin; i < std::min(to, begin + kInTask); ++i) {
        throw_if_stopped();
        take(i);
      }
    });
    if (share.progress)
      share.progress(static_cast<double>(share.before + to) / static_cast<double>(share.all));
  }
}

// A place above the ground by one metre of its own upright, which on the ellipsoid leans away.
struct Upright {
  double along = 0, up = 1; ///< the direction's share and the frame's z's
};

std::size_t directions_below(double step_deg, double end_deg) {
  return static_cast<std::size_t>(std::ceil(end_deg / step_deg * (1 - 1e-12)));
}

} // namespace

LookAround::LookAround(const TerrainData& terrain, std::span<const BorderEdge> border,
                       const Observer& observer)
    : terrain_(terrain), view_(observer.view), lines_(terrain.surface, border, view_),
      bounds_(map_bounds(terrain)) {
  const Vec2 at = view_.depth_origin_m;
  eye_map_ = terrain.map.to_map({at.x, at.y, view_.eye_z_m / view_.exaggeration});
  eye_lonlat_ = lonlat_of_map(terrain.map.crs_wkt, {eye_map_.x, eye_map_.y});
}

LookAround::LookAround(const TerrainData& terrain, std::span<const BorderEdge> border,
                       const Observer& observer, const BlockBounds& bounds)
    : LookAround(terrain, border, observer) {
  over_blocks_.emplace(std::get<Grid>(terrain.surface), bounds, view_, lines_.rounding_m());
}

// Of a terrain in degrees on its own ellipsoid, as it is drawn.
std::optional<Bearing> LookAround::geodesic_to(Vec2 map) const {
  GeoPoint from, to;
  Ellipsoid ellipsoid;
  if (const auto& earth = terrain_.map.earth) {
    from = {eye_map_.x * earth->unit_deg, eye_map_.y * earth->unit_deg, 0};
    to = {map.x * earth->unit_deg, map.y * earth->unit_deg, 0};
    ellipsoid = earth->local.ellipsoid();
  } else {
    const auto lonlat =
        eye_lonlat_ ? lonlat_of_map(terrain_.map.crs_wkt, map) : std::optional<Vec2>();
    if (!lonlat) return std::nullopt;
    from = {eye_lonlat_->x, eye_lonlat_->y, 0};
    to = {lonlat->x, lonlat->y, 0};
  }
  const auto [distance_m, azimuth] = distance_and_azimuth(from, to, ellipsoid);
  return Bearing{in_turn(azimuth.in_degrees()), 0, distance_m};
}

Bearing LookAround::bearing_of(Vec2 map, ProfilePoint at) const {
  const double away_m = std::hypot(at.u, at.v);
  const Vec3 ground = terrain_.map.to_ground_m({map.x, map.y, 0});
  const Vec2 way = Vec2{ground.x, ground.y} - view_.depth_origin_m;
  Bearing out = geodesic_to(map).value_or(Bearing{azimuth_deg(way), 0, away_m});
  out.altitude_deg = atan2_angle(at.z - view_.eye_z_m, away_m).in_degrees();
  return out;
}

Vec2 LookAround::direction(double true_azimuth_deg) const {
  const Angle azimuth = Angle::degrees(true_azimuth_deg);
  if (terrain_.map.earth) return direction_of_azimuth(azimuth); // the frame's north is true
  return direction_of_azimuth(
      map_azimuth(terrain_.map.crs_wkt, {eye_map_.x, eye_map_.y}, azimuth).value_or(azimuth));
}

Vec3 LookAround::to_map(Vec2 direction, double distance_m, double z_m) const {
  return terrain_.map.to_map(
      to_ground_m(view_, {distance_m * direction.x, distance_m * direction.y, z_m}));
}

// Of a place on the ground, whose height is known but for a rounding, what is below it needn't be
// met. If the ground should turn out lower, it must.
SightLine LookAround::sight_line(Vec2 towards, double distance_m,
                                 std::optional<double> ground_z_m) const {
  constexpr double kRounding_m = 1e-3; // a thousand times and more that of a height
  if (over_blocks_ && ground_z_m && distance_m > 0) {
    const double least_z_m = *ground_z_m - kRounding_m;
    const auto sight =
        over_blocks_->up_to(towards, distance_m, (least_z_m - view_.eye_z_m) / distance_m);
    if (sight && sight->ground && sight->ground->z_m >= least_z_m) return *sight;
  }
  return lines_.up_to(towards, distance_m);
}

PlaceSight LookAround::sight_of(Vec2 place, double above_m) const {
  const MapFrame& map = terrain_.map;
  if (map.earth) {
    const double turn = 360 / map.earth->unit_deg;
    place.x -= turn * std::round((place.x - bounds_.centre().x) / turn);
  }
  PlaceSight out;
  const bool within = place.x >= bounds_.low.x && place.x <= bounds_.high.x &&
                      place.y >= bounds_.low.y && place.y <= bounds_.high.y;
  out.state = within ? PlaceState::gap : PlaceState::outside;

  // On the ellipsoid a place lies where its own height puts it.
  const std::optional<Vec3> on_earth = map.earth ? ground_at(place, terrain_) : std::nullopt;
  const Vec3 ground = on_earth ? *on_earth : map.to_ground_m({place.x, place.y, 0});
  const ProfilePoint at = to_profile_frame(view_, ground);
  const double distance_m = std::hypot(at.u, at.v);
  const Vec2 towards = distance_m > 0 ? Vec2{at.u / distance_m, at.v / distance_m} : Vec2{0, 1};
  out.bearing = geodesic_to(place).value_or(Bearing{azimuth_deg(towards), 0, distance_m});
  if (map.earth && !on_earth) return out;
  const Grid* const grid = std::get_if<Grid>(&terrain_.surface);
  const auto height_m =
      grid && !map.earth ? height_at(*grid, {ground.x, ground.y}) : std::optional<double>();
  std::optional<double> ground_z_m;
  if (over_blocks_ && above_m == 0 && map.earth) ground_z_m = at.z;
  if (over_blocks_ && above_m == 0 && height_m)
    ground_z_m = to_profile_frame(view_, {ground.x, ground.y, *height_m}).z;
  const SightLine sight = sight_line(towards, distance_m, ground_z_m);
  if (!sight.ground && !map.earth) return out;
  // By a rounding beside the border there is no section to tell the height.
  const SightPlace own = sight.ground.value_or(SightPlace{distance_m, at.z, lines_.rounding_m()});

  Upright upright;
  if (map.earth) {
    const Vec3 on_map = map.to_map(ground);
    out.height = on_map.z;
    const Vec3 up = map.to_ground_m({place.x, place.y, on_map.z + 1 / map.height_unit_m}) -
                    map.to_ground_m({place.x, place.y, on_map.z});
    const double along = up.x * towards.x + up.y * towards.y, size = std::hypot(along, up.z);
    upright = {along / size, up.z / size};
  } else if (grid) {
    out.height = height_m.value_or(to_ground_m(view_, {at.u, at.v, own.z_m}).z) / map.height_unit_m;
  } else {
    out.height = to_ground_m(view_, {at.u, at.v, own.z_m}).z / map.height_unit_m;
  }
  const double away_m = distance_m + above_m * upright.along;
  const double rise_m = own.z_m + above_m * upright.up - view_.eye_z_m;
  out.bearing.altitude_deg = atan2_angle(rise_m, away_m).in_degrees();
  out.state = PlaceState::seen;
  if (!sight.highest || !(away_m > 0)) return out;
  const double slope = rise_m / away_m;
  const double rounding =
      sight.rounding + (own.rounding_m + lines_.rounding_m() * std::abs(slope)) / away_m;
  out.tied = std::abs(sight.slope - slope) <= rounding;
  if (!(sight.slope - slope > rounding)) return out;
  out.state = PlaceState::hidden;
  out.hidden_m = (sight.slope * away_m - rise_m) / (upright.up - sight.slope * upright.along);
  out.hidden_deg = slope_deg(sight.slope) - slope_deg(slope);
  return out;
}

std::vector<PlaceSight> LookAround::sights(std::span<const Vec2> places, double above_m,
                                           const std::function<void(double)>& progress) const {
  // Round the eye, so that one look finds in the cache what the one before has met.
  std::vector<std::pair<double, std::size_t>> in_turn;
  for (std::size_t i = 0; i < places.size(); ++i)
    in_turn.emplace_back(std::atan2(places[i].x - eye_map_.x, places[i].y - eye_map_.y), i);
  std::ranges::sort(in_turn);
  std::vector<PlaceSight> out(places.size());
  for_each(places.size(), {0, places.size(), progress}, [&](std::size_t k) {
    const std::size_t i = in_turn[k].second;
    out[i] = sight_of(places[i], above_m);
  });
  return out;
}

SkylinePlace LookAround::place_of(Vec2 towards, const SightLine& sight) const {
  SkylinePlace out;
  const SightPlace& at = *sight.highest;
  const Vec3 map = to_map(towards, at.distance_m, at.z_m);
  out.map = {map.x, map.y};
  out.height = map.z;
  out.lonlat = lonlat_of_map(terrain_.map.crs_wkt, out.map);
  out.bearing = geodesic_to(out.map).value_or(Bearing{azimuth_deg(towards), 0, at.distance_m});
  out.bearing.altitude_deg = slope_deg(sight.slope);
  out.at_border = sight.at_border;
  return out;
}

Skyline LookAround::skyline(double step_deg, const std::function<void(double)>& progress) const {
  Skyline out;
  out.directions.resize(directions_below(step_deg, 360));
  const double reach = reach_m(terrain_.surface) + length(view_.depth_origin_m);
  const double between_deg =
      std::clamp(atan2_angle(cell_size_m(terrain_.surface), reach).in_degrees(), 0.01, 1.0);
  std::vector<double> distances_m(directions_below(between_deg, 360));
  const std::size_t all = out.directions.size() + distances_m.size();
  for_each(out.directions.size(), {0, all, progress}, [&](std::size_t i) {
    Skyline::Direction& direction_out = out.directions[i];
    direction_out.azimuth_deg = static_cast<double>(i) * step_deg;
    const Vec2 towards = direction(direction_out.azimuth_deg);
    const SightLine sight = lines_.skyline(towards);
    if (!sight.highest) return;
    direction_out.place = place_of(towards, sight);
    direction_out.place->bearing.azimuth_deg = direction_out.azimuth_deg;
  });

  const auto between = [&](std::size_t i) {
    return direction_of_azimuth(Angle::degrees(static_cast<double>(i) * between_deg));
  };
  for_each(distances_m.size(), {out.directions.size(), all, progress}, [&](std::size_t i) {
    const SightLine sight = lines_.skyline(between(i));
    if (sight.highest) distances_m[i] = sight.highest->distance_m;
  });
  const auto farthest = std::ranges::max_element(distances_m);
  if (farthest != distances_m.end() && *farthest > 0) {
    const Vec2 towards = between(static_cast<std::size_t>(farthest - distances_m.begin()));
    out.most_distant = place_of(towards, lines_.skyline(towards));
  }
  for (const Skyline::Direction& one : out.directions)
    if (one.place && one.place->bearing.distance_m > out.most_distant->bearing.distance_m)
      out.most_distant = one.place;
  return out;
}

} // namespace orograph
