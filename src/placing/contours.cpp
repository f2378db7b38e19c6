// SPDX-License-Identifier: GPL-3.0-or-later
#include "placing/contours.hpp"

#include "geometry/box.hpp"
#include "geometry/error.hpp"
#include "placing/vertex_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

namespace orograph {
namespace {

// Contours that read as form and not as a tone: of the relief of a sheet of a topographic map.
constexpr double kOverRelief = 25;
constexpr double kMostLevels = 10000;

// Of a map whose longer side is 250 mm: where contours are, they are so far apart or more. It is
// two pens' widths; the Alps from valley to summit have 0.8 to 1.4 mm, archipelagos 0.43.
constexpr double kLeastApart = 0.45 / 250;

// How steep the ground is, summed over its plan. Areas count by any unit, the same for all of them.
// At walls and cliffs contours may meet, so a slope counts as 1 at most.
struct Slopes {
  double sum = 0, sum_of_squares = 0;
  Box2 plan_m;

  void add(double area, double squared_slope) {
    const double squared = std::min(squared_slope, 1.0);
    sum += area * std::sqrt(squared);
    sum_of_squares += area * squared;
  }
  // Of the ground that contours lie on: they are as dense as it is steep.
  double under_contours() const { return sum_of_squares / sum; }
};

// Between vertices some half a millimetre apart on that map: what is finer isn't seen, and farther
// ones miss a country's valleys. Every other one does in each direction.
Slopes slopes_of(const Grid& grid, double exaggeration) {
  constexpr int kSteps = 500;
  const int step = std::max(1, std::max(grid.columns, grid.rows) / kSteps);
  Slopes out;
  for (int row = 0; row + step < grid.rows; row += 2 * step)
    for (int column = 0; column + step < grid.columns; column += 2 * step) {
      const double height_m = grid.height_m(column, row),
                   rise_m = grid.height_m(column + step, row) - height_m,
                   other_rise_m = grid.height_m(column, row + step) - height_m;
      if (std::isnan(rise_m + other_rise_m)) continue;
      const Vec3 at = grid.vertex_m(column, row);
      // On the earth up isn't the frame's z.
      const auto squared_run = [&](Vec3 other, double its_rise_m) {
        const Vec3 way = other - at;
        return dot(way, way) - its_rise_m * its_rise_m * exaggeration * exaggeration;
      };
      const double run = squared_run(grid.vertex_m(column + step, row), rise_m),
                   other_run = squared_run(grid.vertex_m(column, row + step), other_rise_m);
      if (!(run > 0 && other_run > 0)) continue;
      out.add(std::sqrt(run * other_run),
              rise_m * rise_m / run + other_rise_m * other_rise_m / other_run);
      out.plan_m.include({at.x, at.y});
    }
  return out;
}

Slopes slopes_of(const Tin& tin) {
  Slopes out;
  for (const auto& [a, b, c] : tin.triangles) {
    const Vec3 at = tin.vertices_m[a],
               normal = cross(tin.vertices_m[b] - at, tin.vertices_m[c] - at);
    if (normal.z == 0) continue;
    out.add(std::abs(normal.z),
            (normal.x * normal.x + normal.y * normal.y) / (normal.z * normal.z));
    out.plan_m.include({at.x, at.y});
  }
  return out;
}

// The interval from which on contours don't run together on that map, as a country's do at a
// twenty-fifth of its relief; 0 where all is level.
double least_interval_m(const TerrainData& terrain) {
  const Grid* grid = std::get_if<Grid>(&terrain.surface);
  const Slopes slopes =
      grid ? slopes_of(*grid, terrain.map.earth ? terrain.map.earth->exaggeration : 1)
           : slopes_of(std::get<Tin>(terrain.surface));
  if (!(slopes.sum > 0)) return 0;
  const double longer_side_m = std::max(slopes.plan_m.width(), slopes.plan_m.height());
  return slopes.under_contours() * longer_side_m * kLeastApart;
}

} // namespace

double round_step(double value) {
  const double power = std::pow(10, std::floor(std::log10(value)));
  double best = power;
  for (const double step : {2 * power, 5 * power, 10 * power})
    if (std::abs(std::log(step / value)) < std::abs(std::log(best / value))) best = step;
  return best;
}

ContourLevels contour_levels(const TerrainData& terrain, const ContourSpec& spec,
                             std::optional<double> base_m) {
  return contour_levels(terrain, height_range_of(terrain), spec, base_m);
}

ContourLevels contour_levels(const TerrainData& terrain, std::pair<double, double> heights_m,
                             const ContourSpec& spec, std::optional<double> base_m) {
  const auto [lowest_m, high_m] = heights_m;
  const double unit_m = spec.unit_m.value_or(terrain.map.height_unit_m);
  const double low_m = base_m.value_or(lowest_m);
  ContourLevels out{{}, {}, {}, lowest_m / unit_m, high_m / unit_m};
  const auto add = [&](double height, bool is_index) {
    const double height_m = height * unit_m;
    if (!(height_m > low_m && height_m <= high_m)) return; // no ground is on its other side
    out.heights_m.push_back(height_m);
    out.heights.push_back(height);
    out.is_index.push_back(is_index);
  };
  if (!spec.levels.empty()) {
    for (const double level : spec.levels) add(level, false);
    return out;
  }
  const double low = low_m / unit_m, high = out.high, relief = high - out.low;
  if (!(low < high) || !(spec.interval || relief > 0)) return out;
  const double interval =
      spec.interval
          ? *spec.interval
          : round_step(std::max(relief / kOverRelief, least_interval_m(terrain) / unit_m));
  const double first = std::floor((low - spec.offset) / interval),
               last = std::ceil((high - spec.offset) / interval);
  if (last - first > kMostLevels)
    throw Error(
        fmt::format("contours every {} would be {:.3g} levels over heights from {:.6g} to "
                    "{:.6g}",
                    interval, last - first, low, high),
        fmt::format("an interval of {} or more", round_step((high - low) / kMostLevels * 2)));
  for (double i = first; i <= last; ++i)
    add(spec.offset + i * interval,
        spec.index_every > 0 && std::fmod(i, static_cast<double>(spec.index_every)) == 0);
  return out;
}

} // namespace orograph
