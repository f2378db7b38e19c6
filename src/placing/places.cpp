// SPDX-License-Identifier: GPL-3.0-or-later
#include "placing/places.hpp"

#include "dem/frame/local_frame.hpp"
#include "dem/height_at.hpp"
#include "dem/read/lonlat.hpp"
#include "geometry/error.hpp"
#include "placing/eye_summit.hpp"
#include "placing/terrain_facts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace orograph {
namespace {

bool holds(const Box2& box, Vec2 p) {
  return p.x >= box.low.x && p.x <= box.high.x && p.y >= box.low.y && p.y <= box.high.y;
}

// Whether longitude and latitude stand for each other: so far aside that no eye stands there, while
// the other way round the place is in the terrain.
void refuse_swapped(const NamedPlace& at, const Box2& bounds) {
  constexpr double kFar_deg = 5;
  const auto [x, y, z] = at.place;
  const Box2 around{bounds.low - Vec2{kFar_deg, kFar_deg}, bounds.high + Vec2{kFar_deg, kFar_deg}};
  if (holds(around, {x, y}) || !holds(bounds, {y, x})) return;
  throw Error(fmt::format("{} is far from the terrain, which holds {},{}", at.text(), y, x),
              "longitude comes first, then latitude: " + at.turned());
}

std::string where_terrain_is(const NamedPlace& at, const MapFrame& map, const Box2& on_map) {
  if (at.lonlat)
    if (const auto bounds = lonlat_bounds(map.crs_wkt, on_map))
      return fmt::format(
          "it lies between longitudes {:.5f} and {:.5f}, latitudes {:.5f} and {:.5f}",
          bounds->low.x, bounds->high.x, bounds->low.y, bounds->high.y);
  return fmt::format("it lies between {:.10g},{:.10g} and {:.10g},{:.10g}", on_map.low.x,
                     on_map.low.y, on_map.high.x, on_map.high.y);
}

// A longitude of the terrain's own turn, whichever turn it was given in.
Vec2 in_turn_of(const TerrainData& terrain, Vec2 place) {
  const double turn = 360 / terrain.map.earth->unit_deg, middle = map_bounds(terrain).centre().x;
  return {place.x - turn * std::round((place.x - middle) / turn), place.y};
}

Vec2 lonlat_on_map(const NamedPlace& at, const TerrainData& terrain) {
  const MapFrame& map = terrain.map;
  if (!has_ground(terrain.surface))
    throw Error(at.in_file + at.name +
                    ": without a terrain there is no place at a longitude and a latitude",
                at.in_file.empty()
                    ? fmt::format("give {},Z in the scene's coordinates", at.on_map())
                    : at.on_map() + ", or a DEM as `terrain` and the scene as `solids`");
  if (map.crs_wkt.empty())
    throw Error(
        fmt::format("{}{}: the terrain has no CRS, so longitudes and latitudes aren't known",
                    at.in_file, at.name),
        fmt::format("give {} in its own coordinates, or the file a CRS", at.on_map()));
  if (!is_on_earth(map.crs_wkt))
    throw Error(fmt::format("{}{}: the terrain's CRS, {}, doesn't tell where on the earth it is",
                            at.in_file, at.name, map.crs_name),
                fmt::format("give {} in its own coordinates", at.on_map()));
  const auto bounds = lonlat_bounds(map.crs_wkt, map_bounds(terrain));
  if (bounds) refuse_swapped(at, *bounds);
  const auto place = map_of_lonlat(map.crs_wkt, {at.place.x, at.place.y});
  if (!place)
    throw Error(fmt::format("{} has no place in the terrain's CRS, {}", at.text(), map.crs_name),
                "longitude comes first, then latitude; the place must be near the terrain");
  // PROJ finds some place in a transverse Mercator's CRS for the earth's other side as well.
  constexpr double kFar_m = 2e6; // from which the eye would have to stand 300 km high
  if (bounds && !map.earth) {
    const double middle = bounds->centre().x;
    const double lon = middle + std::remainder(at.place.x - middle, 360);
    const GeoPoint nearest{std::clamp(lon, bounds->low.x, bounds->high.x),
                           std::clamp(at.place.y, bounds->low.y, bounds->high.y)};
    const double away_m = distance_and_azimuth(nearest, {lon, at.place.y, 0}).distance_m;
    if (!(away_m <= kFar_m))
      throw Error(fmt::format("{} is {:.0f} km away from the terrain", at.text(), away_m / 1000),
                  where_terrain_is(at, map, map_bounds(terrain)));
  }
  return *place;
}

// True height of the vertex nearest to a place; 0 where there is none.
double height_near(const Grid& grid, Vec3 ground_m) {
  const Vec2 at = grid.earth().column_row_at(ground_m);
  const double column = std::clamp(std::round(at.x), 0.0, grid.columns - 1.0);
  const double row = std::clamp(std::round(at.y), 0.0, grid.rows - 1.0);
  const double height = grid.height_m(static_cast<int>(column), static_cast<int>(row));
  return std::isnan(height) ? 0 : height;
}

double height_near(const Tin& tin, const MapFrame& map, Vec3 ground_m) {
  const auto away = [&](const Vec3& vertex) {
    return length(Vec2{vertex.x - ground_m.x, vertex.y - ground_m.y});
  };
  const auto nearest = std::ranges::min_element(tin.vertices_m, {}, away);
  return nearest == tin.vertices_m.end() ? 0 : map.to_map(*nearest).z * map.height_unit_m;
}

Vec3 ground_m(const NamedPlace& at, Vec2 place, const TerrainData& terrain) {
  if (!has_ground(terrain.surface))
    throw Error(at.text() + ": without a terrain there is no ground to stand on",
                fmt::format("give a height, {}", at.with_height()));
  if (const auto ground = ground_at(place, terrain)) return *ground;
  const Box2 bounds = map_bounds(terrain);
  if (holds(bounds, place))
    throw Error(fmt::format("{}: the terrain has a gap there, so the ground's height isn't known",
                            at.text()),
                fmt::format("give a height, {}, or another place", at.with_height()));
  throw Error(
      fmt::format("{} is outside of the terrain, so the ground's height isn't known", at.text()),
      fmt::format("{}; elsewhere give a height, {}", where_terrain_is(at, terrain.map, bounds),
                  at.with_height()));
}

std::optional<NamedPlace> named(const std::string& field, const std::optional<GivenPlace>& map,
                                const std::optional<GivenPlace>& lonlat) {
  if (map) return NamedPlace{"`" + field + "_map`", *map, false};
  if (lonlat) return NamedPlace{"`" + field + "_lonlat`", *lonlat, true};
  return std::nullopt;
}

std::optional<NamedPlace> eye_of(const ViewSpec& view) {
  return named("eye", view.eye_map, view.eye_lonlat);
}
std::optional<NamedPlace> target_of(const ViewSpec& view) {
  return named("look_at", view.look_at_map, view.look_at_lonlat);
}

LookDirection direction(const ViewSpec& view, const MapFrame& map, Vec3 eye_m) {
  const Angle pitch = view.pitch.value_or(Angle());
  if (map.earth) return {*view.look_azimuth, pitch}; // the frame's north is true
  const Vec3 eye = map.to_map(eye_m);
  const auto azimuth = map_azimuth(map.crs_wkt, {eye.x, eye.y}, *view.look_azimuth);
  return {azimuth.value_or(*view.look_azimuth), pitch};
}

} // namespace

std::string NamedPlace::text() const {
  return fmt::format("{}{} {},{}", in_file, name, place.x, place.y);
}

std::string NamedPlace::with_height() const {
  if (in_file.empty()) return name + (lonlat ? " LON,LAT,H" : " X,Y,Z");
  return name + (lonlat ? " = [LON, LAT, HEIGHT]" : " = [X, Y, HEIGHT]");
}

std::string NamedPlace::on_map() const {
  return in_file.empty() ? name.substr(0, name.rfind('_')) + "_map` X,Y" : "at = [X, Y]";
}

std::string NamedPlace::turned() const {
  return in_file.empty() ? fmt::format("{} {},{}", name, place.y, place.x)
                         : fmt::format("{} = [{}, {}]", name, place.y, place.x);
}

Vec2 place_on_map(const NamedPlace& at, const TerrainData& terrain) {
  const Vec2 place = at.lonlat ? lonlat_on_map(at, terrain) : Vec2{at.place.x, at.place.y};
  if (!terrain.map.earth) return place;
  if (!at.lonlat) refuse_swapped(at, map_bounds(terrain));
  if (!(std::abs(place.y * terrain.map.earth->unit_deg) < 90))
    throw Error(fmt::format("{} is no place: its latitude is beyond a pole", at.text()),
                "longitude comes first, then latitude");
  return in_turn_of(terrain, place);
}

// On the ellipsoid uprights lean away from the origin's, so that height and place in the frame are
// found together.
std::optional<Vec3> ground_at(Vec2 place, const TerrainData& terrain) {
  Vec3 at = terrain.map.to_ground_m({place.x, place.y, 0});
  if (!terrain.map.earth) {
    const auto height = height_at(terrain.surface, {at.x, at.y});
    return height ? std::optional(Vec3{at.x, at.y, *height}) : std::nullopt;
  }
  // At about its height, lest it is beyond the terrain's border or a gap's.
  const Grid* grid = std::get_if<Grid>(&terrain.surface);
  const double height_m =
      grid ? height_near(*grid, at) : height_near(std::get<Tin>(terrain.surface), terrain.map, at);
  at = terrain.map.to_ground_m({place.x, place.y, height_m / terrain.map.height_unit_m});
  constexpr int kSteps = 8; // each is nearer by what the upright leans, a fiftieth 100 km away
  Vec3 ground = at;
  for (int i = 0; i < kSteps; ++i) {
    const auto z = height_at(terrain.surface, {at.x, at.y});
    if (!z) return std::nullopt;
    ground = {at.x, at.y, *z};
    const Vec3 next = terrain.map.to_ground_m({place.x, place.y, terrain.map.to_map(ground).z});
    if (next.x == at.x && next.y == at.y) break;
    at = next;
  }
  return ground; // not `at`, which a rounding may have put below it
}

Vec3 place_in_ground_frame(const NamedPlace& at, const TerrainData& terrain,
                           double above_ground_m) {
  const Vec2 place = place_on_map(at, terrain);
  const MapFrame& map = terrain.map;
  if (at.place.z) return map.to_ground_m({place.x, place.y, *at.place.z});
  return ground_m(at, place, terrain) + Vec3{0, 0, above_ground_m};
}

void place_eye(ViewRequest& request, const ViewSpec& asked, const TerrainData& terrain) {
  const ViewSpec view = on_summit(asked, terrain);
  if (const auto eye = eye_of(view)) {
    const double above_m = view.eye_height_m.value_or(kEyeHeight_m) / request.exaggeration;
    request.eye_m = place_in_ground_frame(*eye, terrain, above_m);
    if (view.look_azimuth) request.look = direction(view, terrain.map, *request.eye_m);
  }
  if (const auto target = target_of(view))
    request.look_at_m = place_in_ground_frame(*target, terrain, 0);
}

std::optional<Vec2> given_place(const ViewSpec& asked, const TerrainData& terrain) {
  const ViewSpec view = on_summit(asked, terrain);
  if (const auto eye = eye_of(view)) return place_on_map(*eye, terrain);
  if (const auto target = target_of(view)) return place_on_map(*target, terrain);
  return std::nullopt;
}

} // namespace orograph
