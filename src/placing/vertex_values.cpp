// SPDX-License-Identifier: GPL-3.0-or-later
#include "placing/vertex_values.hpp"

#include "dem/extent.hpp"
#include "geometry/on_all_cores.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

namespace orograph {

VertexValues heights_of(const TerrainData& terrain) {
  if (const Grid* grid = std::get_if<Grid>(&terrain.surface))
    return [grid](std::size_t first, std::span<double> out) {
      std::visit(
          [&](const auto& heights) {
            std::copy_n(heights.data() + first, out.size(), out.begin());
          },
          grid->heights_m);
    };
  return [&tin = std::get<Tin>(terrain.surface), &map = terrain.map](std::size_t first,
                                                                     std::span<double> out) {
    std::transform(tin.vertices_m.begin() + static_cast<std::ptrdiff_t>(first),
                   tin.vertices_m.begin() + static_cast<std::ptrdiff_t>(first + out.size()),
                   out.begin(), [&](Vec3 vertex) {
                     return map.earth ? map.to_map(vertex).z * map.height_unit_m : vertex.z;
                   });
  };
}

std::pair<double, double> height_range_of(const TerrainData& terrain) {
  const Grid* grid = std::get_if<Grid>(&terrain.surface);
  if (!grid) return range_of(terrain.surface, heights_of(terrain));
  const HeightRange range = height_range(*grid);
  return {range.low_m, range.high_m};
}

VertexValues map_coordinates_of(const TerrainData& terrain, MapAxis axis) {
  const MapFrame& map = terrain.map;
  const Grid* grid = std::get_if<Grid>(&terrain.surface);
  const auto of = [axis](const auto& place) { return axis == MapAxis::x ? place.x : place.y; };
  if (!grid)
    return [&tin = std::get<Tin>(terrain.surface), &map, of](std::size_t first,
                                                             std::span<double> out) {
      for (std::size_t i = 0; i < out.size(); ++i)
        out[i] = of(map.to_map(tin.vertices_m[first + i]));
    };
  // Where there is no height there is a place all the same; no triangle has it.
  return [grid, &map, axis, of](std::size_t first, std::span<double> out) {
    const auto columns = static_cast<std::size_t>(grid->columns);
    for (std::size_t i = 0; i < out.size(); ++i) {
      const int column = static_cast<int>((first + i) % columns),
                row = static_cast<int>((first + i) / columns);
      if (std::isnan(grid->height_m(column, row))) {
        out[i] = std::numeric_limits<double>::quiet_NaN();
      } else if (grid->is_on_earth()) {
        const DegreeLattice& degrees = grid->earth().degrees();
        out[i] = (axis == MapAxis::x ? degrees.lon_deg(column) : degrees.lat_deg(row)) /
                 map.earth->unit_deg;
      } else {
        const Vec2 at = grid->plane().position_m(column, row);
        out[i] = of(map.to_map({at.x, at.y, 0}));
      }
    }
  };
}

std::pair<double, double> range_of(const Surface& surface, const VertexValues& values) {
  constexpr std::size_t kOfTask = std::size_t{1} << 16U;
  const Grid* grid = std::get_if<Grid>(&surface);
  const std::size_t count = grid ? grid->size() : std::get<Tin>(surface).vertices_m.size();
  std::vector<std::pair<double, double>> of_tasks((count + kOfTask - 1) / kOfTask,
                                                  {kInfinity, -kInfinity});
  on_all_cores(of_tasks.size(), [&](std::size_t task) {
    const std::size_t first = task * kOfTask;
    std::vector<double> some(std::min(kOfTask, count - first));
    values(first, some);
    auto& [least, greatest] = of_tasks[task];
    for (const double value : some) {
      if (std::isnan(value)) continue;
      least = std::min(least, value);
      greatest = std::max(greatest, value);
    }
  });
  std::pair out{kInfinity, -kInfinity};
  for (const auto& [least, greatest] : of_tasks)
    out = {std::min(out.first, least), std::max(out.second, greatest)};
  return out;
}

} // namespace orograph
