// SPDX-License-Identifier: GPL-3.0-or-later
#include "placing/contours.hpp"

#include "geometry/error.hpp"
#include "placing/vertex_values.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>
#include <variant>

namespace orograph {
namespace {

// Contours that read as form and not as a tone: of the relief of a sheet of a topographic map.
constexpr double kOverRelief = 25;
constexpr double kMostLevels = 10000;

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
  const auto [low_m, high_m] = height_range_of(terrain);
  return contour_levels(low_m, high_m, terrain.map.height_unit_m, spec, base_m);
}

ContourLevels contour_levels(double lowest_m, double high_m, double height_unit_m,
                             const ContourSpec& spec, std::optional<double> base_m) {
  const double unit_m = spec.unit_m.value_or(height_unit_m);
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
  const double interval = spec.interval.value_or(round_step(relief / kOverRelief));
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
