// SPDX-License-Identifier: GPL-3.0-or-later
#include "placing/coordinate_lines.hpp"

#include "dem/read/lonlat.hpp"
#include "geometry/error.hpp"
#include "geometry/on_all_cores.hpp"
#include "placing/contours.hpp"
#include "placing/geodesy.hpp"
#include "placing/vertex_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <numbers>

namespace orograph {
namespace {

constexpr double kMostLines = 10000;
constexpr double kAcross = 6; // of a graticule, or a grid, for a start

// Multiples of `step` from above the least value on.
std::vector<double> multiples(const std::string& coordinate, std::pair<double, double> range,
                              double step) {
  const auto [low, high] = range;
  std::vector<double> out;
  if (!(low < high)) return out;
  const double first = std::floor(low / step) + 1, last = std::floor(high / step);
  if (last - first > kMostLines)
    throw Error(fmt::format("there would be {:.3g} lines of {}, {:.4g} apart", last - first + 1,
                            coordinate, step),
                fmt::format("at most {:.0f}", kMostLines));
  for (double i = first; i <= last; ++i) out.push_back(i * step);
  return out;
}

double span(std::pair<double, double> range) {
  return std::max(0.0, range.second - range.first);
}

// Of angles: whole degrees, minutes, seconds.
double round_angle_deg(double value_deg) {
  constexpr std::array<double, 9> kOf60{1, 2, 5, 10, 15, 20, 30, 45, 60};
  double unit = 1;
  while (value_deg < 0.75 * unit && unit > 1.0 / 3600) unit /= 60;
  if (value_deg < 0.75 / 3600) return round_step(3600 * value_deg) / 3600;
  double best = unit;
  for (const double count : kOf60)
    if (std::abs(std::log(count * unit / value_deg)) < std::abs(std::log(best / value_deg)))
      best = count * unit;
  return best;
}

// Along the profile frame's u, or v.
VertexValues in_view(const TerrainData& terrain, const View& view, bool across) {
  return [&surface = terrain.surface, &view, across](std::size_t first, std::span<double> out) {
    std::visit(
        [&](const auto& s) {
          for (std::size_t i = 0; i < out.size(); ++i) {
            const auto number = static_cast<std::uint32_t>(first + i);
            const ProfilePoint at = line_of(s, view, {number, number}).from;
            out[i] = std::isnan(at.z) ? at.z : across ? at.u : at.v;
          }
        },
        surface);
  };
}

double metres_a_unit(const MapFrame& map, MapAxis axis, double middle_lat_deg) {
  if (!map.earth) return map.unit_m;
  const CurvatureRadii radii =
      map.radii.value_or(CurvatureRadii{kMeanEarthRadius_m, kMeanEarthRadius_m});
  constexpr double kRadians = std::numbers::pi / 180;
  return map.earth->unit_deg * kRadians *
         (axis == MapAxis::y ? radii.meridian_m
                             : radii.prime_vertical_m * std::cos(kRadians * middle_lat_deg));
}

// What rounding leaves apart would be a line beside one of the lattice's instead of along it: both
// coordinates and levels are whole numbers of this, a micrometre on the ground.
constexpr double kQuantum_m = 0x1p-20, kQuantum_deg = 0x1p-36;

VertexValues quantised(VertexValues values, double quantum) {
  return [values = std::move(values), quantum](std::size_t first, std::span<double> out) {
    values(first, out);
    for (double& value : out) value = std::round(value / quantum) * quantum;
  };
}
CoordinateLines lines_of(const char* coordinate, VertexValues values, std::vector<double> levels,
                         double quantum) {
  CoordinateLines out{coordinate, quantised(std::move(values), quantum), levels, std::move(levels)};
  for (double& level : out.levels) level = std::round(level / quantum) * quantum;
  return out;
}

VertexValues scaled(VertexValues values, double factor) {
  return [values = std::move(values), factor](std::size_t first, std::span<double> out) {
    values(first, out);
    for (double& value : out) value *= factor;
  };
}

} // namespace

std::vector<CoordinateLines> mesh_lines(const TerrainData& terrain, const View& view,
                                        const MeshSpec& spec) {
  VertexValues x, y; // in metres
  if (spec.along_view) {
    x = in_view(terrain, view, true);
    y = in_view(terrain, view, false);
  } else {
    x = map_coordinates_of(terrain, MapAxis::x);
    y = map_coordinates_of(terrain, MapAxis::y);
    const auto [south, north] = range_of(terrain.surface, y);
    const double middle_deg =
        terrain.map.earth ? 0.5 * (south + north) * terrain.map.earth->unit_deg : 0;
    x = scaled(std::move(x), metres_a_unit(terrain.map, MapAxis::x, middle_deg));
    y = scaled(std::move(y), metres_a_unit(terrain.map, MapAxis::y, middle_deg));
  }
  const auto of_x = range_of(terrain.surface, x), of_y = range_of(terrain.surface, y);
  const double step_m =
      spec.spacing_m.value_or(std::max(span(of_x), span(of_y)) / (spec.count + 1));
  std::vector<CoordinateLines> out;
  if (!(step_m > 0)) return out;
  // A mesh of so many lines begins a step from its end.
  const auto lines = [&](const char* name, const VertexValues& values,
                         std::pair<double, double> range) {
    if (spec.spacing_m) return lines_of(name, values, multiples(name, range, step_m), kQuantum_m);
    std::vector<double> levels;
    const double count = std::round(span(range) / step_m) - 1;
    for (double i = 1; i <= count; ++i)
      levels.push_back(range.first + i * span(range) / (count + 1));
    return lines_of(name, values, std::move(levels), kQuantum_m);
  };
  if (spec.x) out.push_back(lines("x", x, of_x));
  if (spec.y) out.push_back(lines("y", y, of_y));
  return out;
}

namespace {

// NaN where the CRS has no such place.
Vec2 lonlat_on_map(const MapFrame& map, Vec3 ground_m) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  const Vec3 on_map = map.to_map(ground_m);
  return lonlat_of_map(map.crs_wkt, {on_map.x, on_map.y}).value_or(Vec2{kNaN, kNaN});
}

// Longitudes within half a turn of one of them, so that none jumps between neighbours.
void in_one_turn(std::vector<Vec2>& places) {
  const auto known = std::ranges::find_if(places, [](Vec2 place) { return !std::isnan(place.x); });
  if (known == places.end()) return;
  const double middle = known->x;
  for (Vec2& place : places) place.x -= 360 * std::round((place.x - middle) / 360);
}

// Longitudes and latitudes at places some cells apart, between which they are linear.
class CoarseLonLat {
public:
  CoarseLonLat(const Grid& grid, const MapFrame& map)
      : grid_(grid), columns_((grid.columns - 2) / kCells + 2),
        rows_((grid.rows - 2) / kCells + 2) {
    places_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
    on_all_cores(static_cast<std::size_t>(rows_), [&](std::size_t row) {
      for (int c = 0; c < columns_; ++c) {
        const Vec2 at = grid.plane().position_m(c * kCells, static_cast<int>(row) * kCells);
        places_[row * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(c)] =
            lonlat_on_map(map, {at.x, at.y, 0});
      }
    });
    in_one_turn(places_);
  }

  Vec2 at(std::size_t vertex) const {
    const auto across = static_cast<std::size_t>(grid_.columns);
    const double column = static_cast<double>(vertex % across) / kCells,
                 row = static_cast<double>(vertex / across) / kCells;
    const int c = std::min(static_cast<int>(column), columns_ - 2),
              r = std::min(static_cast<int>(row), rows_ - 2);
    const auto place = [&](int i, int j) {
      return places_[static_cast<std::size_t>(j) * static_cast<std::size_t>(columns_) +
                     static_cast<std::size_t>(i)];
    };
    const double x = column - c, y = row - r;
    return (1 - y) * ((1 - x) * place(c, r) + x * place(c + 1, r)) +
           y * ((1 - x) * place(c, r + 1) + x * place(c + 1, r + 1));
  }

private:
  static constexpr int kCells = 16;
  const Grid& grid_;
  int columns_, rows_;
  std::vector<Vec2> places_;
};

// At every vertex, whether it has a height or not.
std::function<Vec2(std::size_t)> lonlat_of_vertices(const TerrainData& terrain) {
  if (const Grid* grid = std::get_if<Grid>(&terrain.surface))
    return [coarse = std::make_shared<const CoarseLonLat>(*grid, terrain.map)](std::size_t vertex) {
      return coarse->at(vertex);
    };
  const auto& vertices = std::get<Tin>(terrain.surface).vertices_m;
  const auto places = std::make_shared<std::vector<Vec2>>(vertices.size());
  constexpr std::size_t kOfTask = 4096;
  on_all_cores((vertices.size() + kOfTask - 1) / kOfTask, [&](std::size_t task) {
    for (std::size_t i = task * kOfTask; i < std::min(vertices.size(), (task + 1) * kOfTask); ++i)
      (*places)[i] = lonlat_on_map(terrain.map, vertices[i]);
  });
  in_one_turn(*places);
  return [places](std::size_t vertex) { return (*places)[vertex]; };
}

// One of both coordinates, NaN where there is no height.
VertexValues lonlat_values(const TerrainData& terrain,
                           const std::function<Vec2(std::size_t)>& lonlat, MapAxis axis) {
  return [heights = heights_of(terrain), lonlat, axis](std::size_t first, std::span<double> out) {
    heights(first, out);
    for (std::size_t i = 0; i < out.size(); ++i) {
      if (std::isnan(out[i])) continue;
      const Vec2 place = lonlat(first + i);
      out[i] = axis == MapAxis::x ? place.x : place.y;
    }
  };
}

} // namespace

std::vector<CoordinateLines> graticule_lines(const TerrainData& terrain,
                                             std::optional<double> step_deg) {
  const MapFrame& map = terrain.map;
  VertexValues lon, lat;
  if (map.earth) {
    lon = scaled(map_coordinates_of(terrain, MapAxis::x), map.earth->unit_deg);
    lat = scaled(map_coordinates_of(terrain, MapAxis::y), map.earth->unit_deg);
  } else {
    if (!is_on_earth(map.crs_wkt))
      throw Error("a graticule needs to know where on the earth the terrain is: it has no CRS that "
                  "tells",
                  "give the file's CRS, or draw a mesh");
    const auto lonlat = lonlat_of_vertices(terrain);
    lon = lonlat_values(terrain, lonlat, MapAxis::x);
    lat = lonlat_values(terrain, lonlat, MapAxis::y);
  }
  const auto of_lon = range_of(terrain.surface, lon), of_lat = range_of(terrain.surface, lat);
  const double longest = std::max(span(of_lon), span(of_lat));
  if (!(longest > 0)) return {};
  const double step = step_deg.value_or(round_angle_deg(longest / kAcross));
  return {lines_of("longitude", lon, multiples("longitude", of_lon, step), kQuantum_deg),
          lines_of("latitude", lat, multiples("latitude", of_lat, step), kQuantum_deg)};
}

std::vector<CoordinateLines> map_grid_lines(const TerrainData& terrain,
                                            std::optional<double> step_m) {
  if (terrain.map.earth)
    throw Error("a grid of eastings and northings needs a projected CRS: the terrain's counts in "
                "degrees",
                "draw a graticule");
  const VertexValues x = map_coordinates_of(terrain, MapAxis::x),
                     y = map_coordinates_of(terrain, MapAxis::y);
  const auto of_x = range_of(terrain.surface, x), of_y = range_of(terrain.surface, y);
  const double longest = std::max(span(of_x), span(of_y));
  if (!(longest > 0)) return {};
  const double step = step_m ? *step_m / terrain.map.unit_m : round_step(longest / kAcross);
  return {lines_of("easting", x, multiples("easting", of_x, step), kQuantum_m),
          lines_of("northing", y, multiples("northing", of_y, step), kQuantum_m)};
}

} // namespace orograph
