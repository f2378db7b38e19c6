// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/place_eye.hpp"

#include "dem/height_at.hpp"
#include "dem/read/lonlat.hpp"
#include "geometry/error.hpp"

#include <fmt/format.h>

namespace orograph {
namespace {

// A place with the option that gave it.
struct Named {
  std::string option;
  GivenPlace place;
  bool lonlat = false;

  std::string text() const { return fmt::format("{} {},{}", option, place.x, place.y); }
  /// The option as it gives a height as well.
  std::string with_height() const { return option + (lonlat ? " LON,LAT,H" : " X,Y,Z"); }
};

std::optional<Named> named(const std::string& option, const std::optional<GivenPlace>& map,
                           const std::optional<GivenPlace>& lonlat) {
  if (map) return Named{option, *map, false};
  if (lonlat) return Named{option + "-lonlat", *lonlat, true};
  return std::nullopt;
}

bool holds(const Box2& box, Vec2 p) {
  return p.x >= box.low.x && p.x <= box.high.x && p.y >= box.low.y && p.y <= box.high.y;
}

Box2 map_bounds(const MapFrame& map, const Box3& box) {
  const Vec3 low = map.to_map(box.low), high = map.to_map(box.high);
  return {{low.x, low.y}, {high.x, high.y}};
}

// Whether longitude and latitude stand for each other: so far aside that no eye stands there, while
// the other way round the place is in the terrain.
void refuse_swapped(const Named& at, const Box2& bounds) {
  constexpr double kFar_deg = 5;
  const auto [x, y, z] = at.place;
  const Box2 around{bounds.low - Vec2{kFar_deg, kFar_deg}, bounds.high + Vec2{kFar_deg, kFar_deg}};
  if (holds(around, {x, y}) || !holds(bounds, {y, x})) return;
  throw Error(fmt::format("{} is far from the terrain, which holds {},{}", at.text(), y, x),
              fmt::format("longitude comes first, then latitude: {} {},{}", at.option, y, x));
}

Vec2 place_on_map(const Named& at, const MapFrame& map, const Box3& box) {
  if (!at.lonlat) return {at.place.x, at.place.y};
  const std::string in_map = at.option.substr(0, at.option.rfind('-')) + " X,Y";
  if (map.crs_wkt.empty())
    throw Error(fmt::format("{}: the terrain has no CRS, so longitudes and latitudes aren't known",
                            at.option),
                fmt::format("give {} in its own coordinates, or the file a CRS", in_map));
  if (!is_on_earth(map.crs_wkt))
    throw Error(fmt::format("{}: the terrain's CRS, {}, doesn't tell where on the earth it is",
                            at.option, map.crs_name),
                fmt::format("give {} in its own coordinates", in_map));
  if (const auto bounds = lonlat_bounds(map.crs_wkt, map_bounds(map, box)))
    refuse_swapped(at, *bounds);
  const auto place = map_of_lonlat(map.crs_wkt, {at.place.x, at.place.y});
  if (!place)
    throw Error(fmt::format("{} has no place in the terrain's CRS, {}", at.text(), map.crs_name),
                "longitude comes first, then latitude; the place must be near the terrain");
  return *place;
}

std::string where_terrain_is(const Named& at, const MapFrame& map, const Box2& on_map) {
  if (at.lonlat)
    if (const auto bounds = lonlat_bounds(map.crs_wkt, on_map))
      return fmt::format(
          "it lies between longitudes {:.5f} and {:.5f}, latitudes {:.5f} and {:.5f}",
          bounds->low.x, bounds->high.x, bounds->low.y, bounds->high.y);
  return fmt::format("it lies between {:.10g},{:.10g} and {:.10g},{:.10g}", on_map.low.x,
                     on_map.low.y, on_map.high.x, on_map.high.y);
}

double ground_m(const Named& at, Vec2 place, const Terrain& terrain, const Box3& box) {
  const Vec3 ground = terrain.map.to_ground_m({place.x, place.y, 0});
  if (const auto height = height_at(terrain.surface, {ground.x, ground.y})) return *height;
  const Box2 bounds = map_bounds(terrain.map, box);
  if (holds(bounds, place))
    throw Error(fmt::format("{}: the terrain has a gap there, so the ground's height isn't known",
                            at.text()),
                fmt::format("give a height, {}, or another place", at.with_height()));
  throw Error(
      fmt::format("{} is outside of the terrain, so the ground's height isn't known", at.text()),
      fmt::format("{}; elsewhere give a height, {}", where_terrain_is(at, terrain.map, bounds),
                  at.with_height()));
}

Vec3 place_in_ground_frame(const Named& at, const Terrain& terrain, const Box3& box,
                           double above_ground_m) {
  const Vec2 place = place_on_map(at, terrain.map, box);
  Vec3 out = terrain.map.to_ground_m({place.x, place.y, at.place.z.value_or(0)});
  if (!at.place.z) out.z = ground_m(at, place, terrain, box) + above_ground_m;
  return out;
}

LookDirection direction(const RenderSettings& settings, const MapFrame& map, Vec3 eye_m) {
  const Vec3 eye = map.to_map(eye_m);
  const auto azimuth = map_azimuth(map.crs_wkt, {eye.x, eye.y}, *settings.look_azimuth);
  return {azimuth.value_or(*settings.look_azimuth), settings.pitch};
}

} // namespace

void place_eye(ViewRequest& request, const RenderSettings& settings, const Terrain& terrain,
               const Box3& box) {
  if (const auto eye = named("--eye", settings.eye_map, settings.eye_lonlat)) {
    const double above_m = settings.eye_height_m.value_or(kEyeHeight_m) / request.exaggeration;
    request.eye_m = place_in_ground_frame(*eye, terrain, box, above_m);
    if (settings.look_azimuth) request.look = direction(settings, terrain.map, *request.eye_m);
  }
  if (const auto target = named("--look-at", settings.look_at_map, settings.look_at_lonlat))
    request.look_at_m = place_in_ground_frame(*target, terrain, box, 0);
}

} // namespace orograph
