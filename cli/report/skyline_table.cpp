// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/report/skyline_table.hpp"

#include "cli/say.hpp"
#include "write/output_file.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace orograph {

std::string skyline_csv(const Skyline& skyline) {
  std::string text = "azimuth_deg,altitude_deg,distance_m,longitude,latitude\n";
  for (const auto& [azimuth_deg, place] : skyline.directions) {
    text += fmt::format("{:.12g},", azimuth_deg);
    if (place)
      text += fmt::format("{:.9f},{:.3f},", place->bearing.altitude_deg, place->bearing.distance_m);
    else
      text += ",,";
    text += place && place->lonlat
                ? fmt::format("{:.8f},{:.8f}\n", place->lonlat->x, place->lonlat->y)
                : ",\n";
  }
  return text;
}

void write_skyline(const Skyline& skyline, const RenderSettings& settings) {
  write_text(skyline_csv(skyline), settings.skyline_table, settings.write.overwrite);
}

void tell_skyline(const Skyline& skyline, const RenderSettings& settings) {
  std::string line = fmt::format("{}: the skyline in {} directions", settings.skyline_table,
                                 skyline.directions.size());
  if (const auto& far = skyline.most_distant)
    line += fmt::format("; the most distant ground seen is {:.1f} km away in azimuth {:.1f}",
                        far->bearing.distance_m / 1000, far->bearing.azimuth_deg);
  const auto ends = std::ranges::count_if(skyline.directions, [](const auto& direction) {
    return direction.place && direction.place->at_border;
  });
  if (ends > 0)
    line += fmt::format("; in {} directions the terrain ends there, and what is beyond isn't known",
                        ends);
  say_line(line);
}

} // namespace orograph
