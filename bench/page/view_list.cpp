// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/page/view_list.hpp"

#include "cli/options/options.hpp"
#include "geometry/error.hpp"
#include "map/draw_map.hpp"

#include <iterator>
#include <sstream>

namespace orograph {

std::vector<ListedView> view_list(const std::string& text) {
  std::vector<ListedView> views;
  std::istringstream lines(text);
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    std::istringstream rest(line);
    std::string name, dem;
    if (!(rest >> name) || name.front() == '#') continue;
    const std::string where = "line " + std::to_string(number) + " of the views";
    if (!(rest >> dem)) throw Error(where + " has no DEM", "write NAME DEM OPTIONS");
    std::vector<std::string> arguments{dem, name + ".svg"};
    arguments.insert(arguments.end(), std::istream_iterator<std::string>(rest), {});
    try {
      const auto settings = parse_render(arguments);
      if (!settings) throw Error(where + " asks for help", "leave that out");
      views.push_back({name, *settings});
    } catch (const UsageError& error) {
      throw Error(where + ": " + error.what(), "orograph render knows these options");
    }
  }
  return views;
}

ViewOnPage::ViewOnPage(const ListedView& listed)
    : whole_(read_ground(listed.settings)), terrain_(whole_, listed.settings.map.view),
      placed_(placed_view(terrain_, listed.settings.map)) {
  const Grid* const on_plane = std::get_if<Grid>(&terrain_->surface);
  if (!on_plane || on_plane->is_on_earth())
    throw Error(listed.name + ": the terrain isn't a grid on a map plane",
                "bring it to metres with gdalwarp, and cut it by no planes");
  map_ = draw_map(*terrain_, placed_, listed.settings.map, [](double) {});
}

} // namespace orograph
