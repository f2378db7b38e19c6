// SPDX-License-Identifier: GPL-3.0-or-later
#include "placing/highest_vertex.hpp"

#include "dem/frame/local_frame.hpp"
#include "geometry/on_all_cores.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <unordered_map>
#include <variant>

namespace orograph {
namespace {

using Best = std::optional<HighestVertex>;

void take(Best& best, const HighestVertex& other) {
  if (!best || other.height_m > best->height_m ||
      (other.height_m == best->height_m && other.distance_m < best->distance_m))
    best = other;
}

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
Best search(const Grid& grid, Vec2 middle, Vec2 reach, double within_m, const At& at,
            const Away& away_m) {
  const auto [left, right] = numbers_about(middle.x, reach.x, grid.columns);
  const auto [top, bottom] = numbers_about(middle.y, reach.y, grid.rows);
  // The highest first, so that distances, which take long on the ellipsoid, are asked for a few.
  struct Vertex {
    double height_m;
    int column, row;
  };
  std::vector<Vertex> vertices;
  for (int r = top; r <= bottom; ++r)
    for (int c = left; c <= right; ++c) {
      throw_if_stopped(static_cast<std::size_t>(c));
      const double height_m = grid.height_m(c, r);
      if (!std::isnan(height_m)) vertices.push_back({height_m, c, r});
    }
  const auto is_later = [](const Vertex& a, const Vertex& b) {
    return std::tuple(-a.height_m, a.row, a.column) > std::tuple(-b.height_m, b.row, b.column);
  };
  std::ranges::make_heap(vertices, is_later);
  Best best;
  while (!vertices.empty()) {
    std::ranges::pop_heap(vertices, is_later);
    const auto [height_m, c, r] = vertices.back();
    vertices.pop_back();
    if (best && height_m < best->height_m) break;
    const double distance_m = away_m(c, r);
    if (distance_m <= within_m && has_triangle(grid, c, r))
      take(best, {static_cast<std::uint32_t>(grid.index(c, r)), at(c, r), height_m, distance_m});
  }
  return best;
}

Best search_plane(const Grid& grid, const MapFrame& map, Vec2 place, double within_m) {
  const auto& [first_vertex_m, column_step_m, row_step_m] = grid.plane();
  const Vec3 ground = map.to_ground_m({place.x, place.y, 0});
  const Vec2 here{ground.x, ground.y}, from_first = here - first_vertex_m;
  const double area = cross(column_step_m, row_step_m);
  const Vec2 middle{cross(from_first, row_step_m) / area, cross(column_step_m, from_first) / area};
  const Vec2 reach{within_m * length(row_step_m) / std::abs(area),
                   within_m * length(column_step_m) / std::abs(area)};
  return search(
      grid, middle, reach, within_m,
      [&](int c, int r) {
        const Vec2 at = grid.plane().position_m(c, r);
        const Vec3 on_map = map.to_map({at.x, at.y, 0});
        return Vec2{on_map.x, on_map.y};
      },
      [&](int c, int r) { return length(grid.plane().position_m(c, r) - here); });
}

Best search_earth(const Grid& grid, const EarthFrame& earth, Vec2 place, double within_m) {
  const DegreeLattice& lattice = grid.earth().degrees();
  const Ellipsoid& ellipsoid = earth.local.ellipsoid();
  const GeoPoint here{place.x * earth.unit_deg, place.y * earth.unit_deg, 0};
  // No degree is shorter than that of a sphere a hundredth smaller than the ellipsoid is curved
  // anywhere; near a pole all longitudes are near.
  const double narrow = 1 - ellipsoid.flattening(),
               smaller_m = 0.99 * ellipsoid.semi_major_axis_m * narrow * narrow;
  const double reach_deg = within_m / (smaller_m * Angle::degrees(1).in_radians());
  const double narrowest = cos(Angle::degrees(std::min(std::abs(here.lat_deg) + reach_deg, 90.0)));
  const double lon_reach_deg = std::min(reach_deg / std::max(narrowest, 1e-9), 360.0);
  const Vec2 middle{(here.lon_deg - lattice.first_lon_deg) / lattice.lon_step_deg,
                    (here.lat_deg - lattice.first_lat_deg) / lattice.lat_step_deg};
  const double here_cos = cos(Angle::degrees(here.lat_deg));
  const Vec2 reach{lon_reach_deg / std::abs(lattice.lon_step_deg),
                   reach_deg / std::abs(lattice.lat_step_deg)};
  return search(
      grid, middle, reach, within_m,
      [&](int c, int r) {
        return Vec2{lattice.lon_deg(c) / earth.unit_deg, lattice.lat_deg(r) / earth.unit_deg};
      },
      [&](int c, int r) {
        // So is each way, and a chord of that sphere yet more: it tells what is too far.
        const double lat_deg = lattice.lat_deg(r), lon_deg = lattice.lon_deg(c);
        const double across = sin(Angle::degrees(0.5 * (lat_deg - here.lat_deg))),
                     along = sin(Angle::degrees(0.5 * (lon_deg - here.lon_deg)));
        const double chord_m =
            2 * smaller_m *
            std::sqrt(across * across + here_cos * cos(Angle::degrees(lat_deg)) * along * along);
        if (chord_m > within_m) return chord_m;
        return distance_and_azimuth(here, {lon_deg, lat_deg, 0}, ellipsoid).distance_m;
      });
}

// The places in squares as wide as they look far, so that a vertex asks those of nine.
class PlacesBySquare {
public:
  PlacesBySquare(const MapFrame& map, std::span<const Vec2> places, double within_m)
      : side_m_(std::max(within_m, 1e-3)) {
    for (std::size_t i = 0; i < places.size(); ++i) {
      const Vec3 at = map.to_ground_m({places[i].x, places[i].y, 0});
      ground_m_.push_back({at.x, at.y});
      squares_[key(number(at.x), number(at.y))].push_back(i);
    }
  }

  Vec2 ground_m(std::size_t place) const { return ground_m_[place]; }

  template <class Take>
  void near(Vec3 vertex_m, const Take& take) const {
    const std::int64_t x = number(vertex_m.x), y = number(vertex_m.y);
    for (std::int64_t i = x - 1; i <= x + 1; ++i)
      for (std::int64_t j = y - 1; j <= y + 1; ++j)
        if (const auto found = squares_.find(key(i, j)); found != squares_.end())
          for (const std::size_t place : found->second) take(place);
  }

private:
  std::int64_t number(double at_m) const {
    return static_cast<std::int64_t>(std::floor(at_m / side_m_));
  }
  static std::uint64_t key(std::int64_t x, std::int64_t y) {
    return static_cast<std::uint64_t>(x) << 32U ^ (static_cast<std::uint64_t>(y) & 0xffffffffU);
  }

  double side_m_;
  std::vector<Vec2> ground_m_;
  std::unordered_map<std::uint64_t, std::vector<std::size_t>> squares_;
};

std::vector<Best> search_tin(const Tin& tin, const MapFrame& map, std::span<const Vec2> places,
                             double within_m) {
  const PlacesBySquare by_square(map, places, within_m);
  std::vector<Best> out(places.size());
  for (std::size_t t = 0; t < tin.triangles.size(); ++t) {
    throw_if_stopped(t);
    for (const std::uint32_t i : tin.triangles[t]) {
      const Vec3& vertex = tin.vertices_m[i];
      by_square.near(vertex, [&](std::size_t place) {
        const double distance_m = length(Vec2{vertex.x, vertex.y} - by_square.ground_m(place));
        if (!(distance_m <= within_m)) return;
        const Vec3 at = map.to_map(vertex);
        take(out[place], {i, {at.x, at.y}, vertex.z, distance_m});
      });
    }
  }
  return out;
}

} // namespace

std::vector<std::optional<HighestVertex>>
highest_vertices(const TerrainData& terrain, std::span<const Vec2> places, double within_m) {
  const MapFrame& map = terrain.map;
  if (const Tin* tin = std::get_if<Tin>(&terrain.surface))
    return search_tin(*tin, map, places, within_m);
  const Grid& grid = std::get<Grid>(terrain.surface);
  std::vector<Best> out(places.size());
  on_all_cores(places.size(), [&](std::size_t i) {
    out[i] = grid.is_on_earth() ? search_earth(grid, *map.earth, places[i], within_m)
                                : search_plane(grid, map, places[i], within_m);
  });
  return out;
}

} // namespace orograph
