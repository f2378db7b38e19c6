// SPDX-License-Identifier: GPL-3.0-or-later
// What a command reads of a terrain.
#include "cli/option_groups.hpp"
#include "cli/option_kinds.hpp"
#include "cli/option_values.hpp"

#include <limits>

namespace orograph {
namespace {

constexpr auto kGroup = "Terrain";

} // namespace

void add_terrain_options(std::vector<Option>& options, std::string& input, ReadOptions& reading) {
  options.push_back({.name = "INPUT",
                     .help = "the terrain: any raster of heights that GDAL opens, in a projected "
                             "CRS or none; /vsizip/ and other /vsi paths too",
                     .take = stored_name(input)});
  options.push_back(with_integer({.group = kGroup,
                                  .name = "--band",
                                  .letter = 'b',
                                  .value = "N",
                                  .help = "Band that holds the heights",
                                  .by_default = std::to_string(reading.band)},
                                 1, std::numeric_limits<int>::max(),
                                 [&reading](int n) { reading.band = n; }));
  options.push_back({.group = kGroup,
                     .name = "--oo",
                     .value = "NAME=VALUE",
                     .help = "Open option for GDAL's driver; may be repeated",
                     .repeatable = true,
                     .take = [&reading](const std::string& text) {
                       const auto equals = text.find('=');
                       if (equals == 0 || equals == std::string::npos) return false;
                       reading.open_options.push_back(text);
                       return true;
                     }});
  options.push_back(
      {.group = kGroup,
       .name = "--bbox",
       .value = "XMIN,YMIN,XMAX,YMAX",
       .help = "Keep only the terrain inside this window",
       .allowed = "coordinates of the terrain's CRS, XMIN below XMAX, YMIN below YMAX",
       .by_default = "all of it",
       .take = stored(parse_box, reading.bbox)});
  options.push_back(with_integer({.group = kGroup,
                                  .name = "--overview",
                                  .value = "LEVEL",
                                  .help = "Read a smaller overview of the file instead of the full "
                                          "heights; 0 is the finest overview",
                                  .by_default = "full heights"},
                                 0, 100, [&reading](int level) { reading.overview = level; }));
}

} // namespace orograph
