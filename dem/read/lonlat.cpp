// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/read/lonlat.hpp"

#include "dem/read/crs_frame.hpp"

#include <ogr_spatialref.h>

#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include "gdal/gdal.hpp"

namespace orograph {
namespace {

enum class Way { to_lonlat, to_map };

using Transformation = std::unique_ptr<OGRCoordinateTransformation>;

Transformation make_transformation(const std::string& crs_wkt, const Crs& earth, Way way) {
  if (crs_wkt.empty()) return nullptr;
  const Crs map = plane_of(crs_from_text(crs_wkt));
  if (!map || !earth || map->IsLocal()) return nullptr;
  Transformation there(OGRCreateCoordinateTransformation(map.get(), earth.get()));
  if (way == Way::to_lonlat || !there) return there;
  return Transformation(there->GetInverse());
}

// Null where there is none. Valid until the next call with the same way in the same thread: the
// last one is kept, since PROJ takes a millisecond to make one, and a run has a single CRS.
OGRCoordinateTransformation* transformation(const std::string& crs_wkt, Way way) {
  struct Kept {
    std::string crs_wkt;
    Transformation transform;
  };
  // Made before `kept`, it is freed after it, and after both what GDAL keeps for the thread. Freed
  // earlier, that would be made again by the freeing of `kept`, and leak.
  thread_local const Crs earth = plane_of(crs_from_text("EPSG:4326"));
  thread_local std::array<Kept, 2> kept; // by way
  Kept& last = kept[way == Way::to_lonlat ? 0 : 1];
  if (!last.transform || last.crs_wkt != crs_wkt)
    last = {crs_wkt, make_transformation(crs_wkt, earth, way)};
  return last.transform.get();
}

// All of the places, or nothing.
std::optional<std::vector<Vec2>> all_moved(const std::string& crs_wkt, Way way,
                                           const std::vector<Vec2>& places) {
  const GdalMessages unheard;
  OGRCoordinateTransformation* const transform = transformation(crs_wkt, way);
  if (!transform) return std::nullopt;
  std::vector<Vec2> out;
  for (const Vec2 place : places) {
    const std::optional<Vec2> there = moved(*transform, place);
    if (!there) return std::nullopt;
    out.push_back(*there);
  }
  return out;
}

// Metres in a degree of longitude (x) and of latitude (y), on WGS 84: by the radii of curvature
// across the meridian and along it.
Vec2 metres_per_degree(double latitude_deg) {
  constexpr double a_m = 6378137, f = 1 / 298.257223563, e2 = f * (2 - f);
  const Angle latitude = Angle::degrees(latitude_deg);
  const double s = sin(latitude), w2 = 1 - e2 * s * s, w = std::sqrt(w2);
  const double per_radian = a_m / w;
  const double radians = Angle::degrees(1).in_radians();
  return {radians * per_radian * cos(latitude), radians * per_radian * (1 - e2) / w2};
}

double within_half_turn(double deg) {
  return std::remainder(deg, 360);
}

// Long enough for the rounding of coordinates, short enough for the earth to be flat.
constexpr double kStep_m = 10;

} // namespace

bool is_on_earth(const std::string& crs_wkt) {
  const GdalMessages unheard;
  return transformation(crs_wkt, Way::to_lonlat) != nullptr;
}

std::optional<Vec2> lonlat_of_map(const std::string& crs_wkt, Vec2 map) {
  const auto places = all_moved(crs_wkt, Way::to_lonlat, {map});
  if (!places) return std::nullopt;
  return places->front();
}

std::optional<Vec2> map_of_lonlat(const std::string& crs_wkt, Vec2 lonlat_deg) {
  const auto places =
      all_moved(crs_wkt, Way::to_map, {{within_half_turn(lonlat_deg.x), lonlat_deg.y}});
  if (!places) return std::nullopt;
  return places->front();
}

std::optional<Box2> lonlat_bounds(const std::string& crs_wkt, const Box2& map) {
  constexpr int kSteps = 16;
  std::vector<Vec2> lattice;
  for (int i = 0; i <= kSteps; ++i)
    for (int k = 0; k <= kSteps; ++k)
      lattice.push_back(
          {map.low.x + map.width() * i / kSteps, map.low.y + map.height() * k / kSteps});
  const auto places = all_moved(crs_wkt, Way::to_lonlat, lattice);
  if (!places) return std::nullopt;
  Box2 bounds;
  for (const Vec2 p : *places) {
    const double first = places->front().x;
    bounds.include({first + within_half_turn(p.x - first), p.y});
  }
  return bounds;
}

std::optional<Box2> map_bounds_of_lonlat(const std::string& crs_wkt, const Box2& lonlat_deg,
                                         std::optional<double> turn) {
  constexpr int kSteps = 1000;
  const Vec2 low = lonlat_deg.low, high = lonlat_deg.high;
  const std::array<Vec2, 5> corners{low, Vec2{high.x, low.y}, high, Vec2{low.x, high.y}, low};
  std::vector<Vec2> sides;
  for (std::size_t side = 0; side < 4; ++side)
    for (int i = 0; i < kSteps; ++i) {
      const Vec2 p = corners[side] + i / double{kSteps} * (corners[side + 1] - corners[side]);
      sides.push_back({within_half_turn(p.x), p.y});
    }
  auto places = all_moved(crs_wkt, Way::to_map, sides);
  if (!places) return std::nullopt;
  Box2 bounds;
  Vec2 before = places->front();
  for (Vec2 p : *places) {
    if (turn) p.x = before.x + std::remainder(p.x - before.x, *turn);
    bounds.include(p);
    before = p;
  }
  return bounds;
}

std::optional<Angle> map_azimuth(const std::string& crs_wkt, Vec2 map, Angle true_azimuth) {
  const auto at = lonlat_of_map(crs_wkt, map);
  if (!at) return std::nullopt;
  const Vec2 along = direction_of_azimuth(true_azimuth), per_degree = metres_per_degree(at->y);
  const Vec2 step{kStep_m * along.x / per_degree.x, kStep_m * along.y / per_degree.y};
  const auto ends = all_moved(crs_wkt, Way::to_map, {*at - step, *at + step});
  if (!ends) return std::nullopt;
  const Vec2 on_map = ends->back() - ends->front();
  return atan2_angle(on_map.x, on_map.y);
}

std::optional<Angle> true_azimuth(const std::string& crs_wkt, Vec2 map, Angle map_azimuth) {
  const Vec2 step = kStep_m * direction_of_azimuth(map_azimuth);
  const auto ends = all_moved(crs_wkt, Way::to_lonlat, {map - step, map, map + step});
  if (!ends) return std::nullopt;
  const Vec2 per_degree = metres_per_degree((*ends)[1].y), turned = ends->back() - ends->front();
  return atan2_angle(per_degree.x * within_half_turn(turned.x), per_degree.y * turned.y);
}

} // namespace orograph
