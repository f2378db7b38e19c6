// SPDX-License-Identifier: GPL-3.0-or-later
#include "placing/eye_summit.hpp"

#include "dem/frame/local_frame.hpp"
#include "geometry/error.hpp"
#include "geometry/on_all_cores.hpp"
#include "placing/places.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace orograph {
namespace {

NamedPlace eye_place(const ViewSpec& view) {
  return view.eye_map ? NamedPlace{"`eye_map`", *view.eye_map, false}
                      : NamedPlace{"`eye_lonlat`", *view.eye_lonlat, true};
}

struct Summit {
  Vec2 map;
  double height_m = -std::numeric_limits<double>::infinity(), distance_m = 0;

  void take(Vec2 at, double height, double distance) {
    if (height > height_m || (height == height_m && distance < distance_m))
      *this = {at, height, distance};
  }
};

bool has_triangle(const Grid& grid, int column, int row) {
  const auto there = [&](int right, int down) {
    const int c = column + right, r = row + down;
    return c >= 0 && r >= 0 && c < grid.columns && r < grid.rows &&
           !std::isnan(grid.height_m(c, r));
  };
  // Round the vertex: each two of them that follow make a triangle with it.
  constexpr int kRound[7][2] = {{1, 0}, {1, 1}, {0, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, 0}};
  bool before = false;
  for (const auto& [right, down] : kRound) {
    const bool now = there(right, down);
    if (before && now) return true;
    before = now;
  }
  return false;
}

struct Numbers {
  int first, last;
};
Numbers numbers_about(double middle, double reach, int count) {
  const auto number = [&](double at) { return static_cast<int>(std::clamp(at, 0.0, count - 1.0)); };
  return {number(std::floor(middle - reach)), number(std::ceil(middle + reach))};
}

// Vertices of a grid within so many columns and rows of a place; at(column, row) is their place on
// the map, away_m(column, row) their distance.
template <class At, class Away>
void search(const Grid& grid, Vec2 middle, Vec2 reach, double within_m, const At& at,
            const Away& away_m, Summit& best) {
  const auto [left, right] = numbers_about(middle.x, reach.x, grid.columns);
  const auto [top, bottom] = numbers_about(middle.y, reach.y, grid.rows);
  for (int r = top; r <= bottom; ++r)
    for (int c = left; c <= right; ++c) {
      throw_if_stopped(static_cast<std::size_t>(c));
      const double height_m = grid.height_m(c, r);
      if (!(height_m >= best.height_m)) continue;
      const double distance_m = away_m(c, r);
      if (distance_m <= within_m && has_triangle(grid, c, r))
        best.take(at(c, r), height_m, distance_m);
    }
}

void search_plane(const Grid& grid, const MapFrame& map, Vec2 place, double within_m,
                  Summit& best) {
  const auto& [first_vertex_m, column_step_m, row_step_m] = grid.plane();
  const Vec3 ground = map.to_ground_m({place.x, place.y, 0});
  const Vec2 here{ground.x, ground.y}, from_first = here - first_vertex_m;
  const double area = cross(column_step_m, row_step_m);
  const Vec2 middle{cross(from_first, row_step_m) / area, cross(column_step_m, from_first) / area};
  const Vec2 reach{within_m * length(row_step_m) / std::abs(area),
                   within_m * length(column_step_m) / std::abs(area)};
  search(
      grid, middle, reach, within_m,
      [&](int c, int r) {
        const Vec2 at = grid.plane().position_m(c, r);
        const Vec3 on_map = map.to_map({at.x, at.y, 0});
        return Vec2{on_map.x, on_map.y};
      },
      [&](int c, int r) { return length(grid.plane().position_m(c, r) - here); }, best);
}

void search_earth(const Grid& grid, const EarthFrame& earth, Vec2 place, double within_m,
                  Summit& best) {
  const DegreeLattice& lattice = grid.earth().degrees();
  const Ellipsoid& ellipsoid = earth.local.ellipsoid();
  const GeoPoint here{place.x * earth.unit_deg, place.y * earth.unit_deg, 0};
  // No degree is shorter than that of a sphere a hundredth smaller; near a pole all longitudes are
  // near.
  const double reach_deg =
      within_m / (0.99 * ellipsoid.semi_major_axis_m * Angle::degrees(1).in_radians());
  const double narrowest = cos(Angle::degrees(std::min(std::abs(here.lat_deg) + reach_deg, 90.0)));
  const double lon_reach_deg = std::min(reach_deg / std::max(narrowest, 1e-9), 360.0);
  const Vec2 middle{(here.lon_deg - lattice.first_lon_deg) / lattice.lon_step_deg,
                    (here.lat_deg - lattice.first_lat_deg) / lattice.lat_step_deg};
  const Vec2 reach{lon_reach_deg / std::abs(lattice.lon_step_deg),
                   reach_deg / std::abs(lattice.lat_step_deg)};
  search(
      grid, middle, reach, within_m,
      [&](int c, int r) {
        return Vec2{lattice.lon_deg(c) / earth.unit_deg, lattice.lat_deg(r) / earth.unit_deg};
      },
      [&](int c, int r) {
        return distance_and_azimuth(here, {lattice.lon_deg(c), lattice.lat_deg(r), 0}, ellipsoid)
            .distance_m;
      },
      best);
}

void search_tin(const Tin& tin, const MapFrame& map, Vec2 place, double within_m, Summit& best) {
  const Vec3 here = map.to_ground_m({place.x, place.y, 0});
  for (std::size_t t = 0; t < tin.triangles.size(); ++t) {
    throw_if_stopped(t);
    for (const std::uint32_t i : tin.triangles[t]) {
      const Vec3& vertex = tin.vertices_m[i];
      const double distance_m = length(Vec2{vertex.x - here.x, vertex.y - here.y});
      if (!(distance_m <= within_m) || !(vertex.z >= best.height_m)) continue;
      const Vec3 at = map.to_map(vertex);
      best.take({at.x, at.y}, vertex.z, distance_m);
    }
  }
}

} // namespace

std::optional<EyeMove> eye_move(const ViewSpec& view, const TerrainData& terrain) {
  if (!view.eye_summit_m || !view.has_eye()) return std::nullopt;
  const NamedPlace named = eye_place(view);
  const Vec2 place = place_on_map(named, terrain);
  const MapFrame& map = terrain.map;
  EyeMove out{place, place};
  Summit best;
  if (has_ground(terrain.surface))
    if (const auto ground = ground_at(place, terrain)) {
      out.from_m = map.to_map(*ground).z * map.height_unit_m;
      best = {place, *out.from_m, 0};
    }
  if (const Tin* tin = std::get_if<Tin>(&terrain.surface))
    search_tin(*tin, map, place, *view.eye_summit_m, best);
  else if (const Grid& grid = std::get<Grid>(terrain.surface); grid.is_on_earth())
    search_earth(grid, *map.earth, place, *view.eye_summit_m, best);
  else
    search_plane(grid, map, place, *view.eye_summit_m, best);
  if (!std::isfinite(best.height_m))
    throw Error(fmt::format("{}: there is no ground within {} m to put the eye on", named.text(),
                            *view.eye_summit_m),
                "give a place on the terrain, or a greater `eye_summit_m`");
  out.to_map = best.map;
  out.distance_m = best.distance_m;
  out.to_m = best.height_m;
  return out;
}

ViewSpec on_summit(const ViewSpec& view, const TerrainData& terrain) {
  const auto move = eye_move(view, terrain);
  ViewSpec out = view;
  out.eye_summit_m.reset();
  if (!move) return out;
  GivenPlace eye(move->to_map.x, move->to_map.y);
  if (const auto& z = view.eye_map ? view.eye_map->z : view.eye_lonlat->z) {
    if (!move->from_m)
      throw Error(eye_place(view).text() +
                      ": there is no ground there, so the eye's height above it isn't known",
                  "leave its height out, or `eye_summit_m`");
    eye.z = *z + (move->to_m - *move->from_m) / terrain.map.height_unit_m;
  }
  out.eye_map = eye;
  out.eye_lonlat.reset();
  return out;
}

} // namespace orograph
