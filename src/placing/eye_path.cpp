// SPDX-License-Identifier: GPL-3.0-or-later
#include "placing/eye_path.hpp"

#include "dem/frame/local_frame.hpp"
#include "dem/read/lonlat.hpp"
#include "dem/read/read_line.hpp"
#include "geometry/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace orograph {
namespace {

constexpr double kMostEyes = 1e6;

// Between the CRS of the line and the terrain's, through longitude and latitude.
Vec3 on_map(Vec3 p, const MapLine& line, const MapFrame& map, const std::string& path) {
  if (line.crs_wkt.empty() || map.crs_wkt.empty() || line.crs_wkt == map.crs_wkt) return p;
  const auto lonlat = lonlat_of_map(line.crs_wkt, {p.x, p.y});
  const auto place = lonlat ? map_of_lonlat(map.crs_wkt, *lonlat) : std::nullopt;
  if (!place)
    throw Error(fmt::format("{}: {}, {} is no place in the terrain's CRS", path, p.x, p.y),
                "bring the line near the terrain, or to its CRS");
  return {place->x, place->y, p.z};
}

// Distance and direction from one place to the next.
struct Way {
  double distance_m;
  Angle azimuth; ///< from true north where the CRS tells it
};

Way way(Vec2 from, Vec2 to, const MapFrame& map) {
  const auto a = lonlat_of_map(map.crs_wkt, from), b = lonlat_of_map(map.crs_wkt, to);
  if (a && b) {
    const auto [distance_m, azimuth] = distance_and_azimuth({a->x, a->y, 0}, {b->x, b->y, 0});
    return {distance_m, azimuth};
  }
  const Vec2 along = to - from;
  return {length(along) * map.unit_m, atan2_angle(along.x, along.y)};
}

Vec3 between(Vec3 a, Vec3 b, double share) {
  return a + share * (b - a);
}

// Places along the line, and the leg that each begins or lies on.
struct Stop {
  Vec3 place;
  std::size_t leg;
};

std::vector<Stop> stops(const std::vector<Vec3>& points, const std::vector<Way>& legs,
                        std::optional<double> step_m, const std::string& path) {
  std::vector<Stop> out;
  if (!step_m) {
    for (std::size_t i = 0; i < points.size(); ++i)
      out.push_back({points[i], std::min(i, legs.size() - 1)});
    return out;
  }
  double total_m = 0;
  for (const Way& leg : legs) total_m += leg.distance_m;
  if (!(total_m / *step_m <= kMostEyes))
    throw Error(fmt::format("{} is {:.4g} m long: steps of {} m make {:.3g} eyes", path, total_m,
                            *step_m, total_m / *step_m),
                "give a larger `step_m`");
  double begin_m = 0; // of the leg
  std::size_t leg = 0;
  for (double i = 0;; ++i) {
    const double at_m = i * *step_m;
    if (at_m > total_m * (1 + 1e-12)) return out;
    while (leg + 1 < legs.size() && at_m >= begin_m + legs[leg].distance_m)
      begin_m += legs[leg++].distance_m;
    const double share = std::min((at_m - begin_m) / legs[leg].distance_m, 1.0);
    out.push_back({between(points[leg], points[leg + 1], share), leg});
  }
}

} // namespace

std::vector<PathEye> read_eye_path(const std::string& path, std::optional<double> step_m,
                                   const MapFrame& map, bool allow_network) {
  const MapLine line = read_line(path, allow_network);
  std::vector<Vec3> points;
  std::vector<Way> legs;
  for (const Vec3& given : line.points) {
    const Vec3 p = on_map(given, line, map, path);
    if (!points.empty()) {
      const Way leg = way({points.back().x, points.back().y}, {p.x, p.y}, map);
      if (!(leg.distance_m > 0)) continue; // the same place again
      legs.push_back(leg);
    }
    points.push_back(p);
  }
  if (legs.empty())
    throw Error(path + ": its line has no length", "a path has two places at least");
  std::vector<PathEye> eyes;
  for (const Stop& stop : stops(points, legs, step_m, path)) {
    const Vec3 at = stop.place;
    eyes.push_back(
        {line.has_heights ? GivenPlace(at) : GivenPlace(at.x, at.y), legs[stop.leg].azimuth});
  }
  return eyes;
}

} // namespace orograph
