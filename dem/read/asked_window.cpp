// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/read/asked_window.hpp"

#include "dem/read/crs_frame.hpp"
#include "dem/read/lonlat.hpp"
#include "dem/terrain.hpp"
#include "geometry/error.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orograph {

std::string in_words(const Box2& box) {
  return fmt::format("{:.10g},{:.10g} to {:.10g},{:.10g}", box.low.x, box.low.y, box.high.x,
                     box.high.y);
}

void check_window(const Box2& window, const Box2& extent) {
  if (window.empty())
    throw Error(fmt::format("the window {} is empty", in_words(window)),
                fmt::format("its first corner must be south-west of its second; the terrain "
                            "reaches from {}",
                            in_words(extent)));
}

void refuse_window(const Box2& window, const Box2& extent, const std::string& path) {
  throw Error(fmt::format("the window {} holds nothing of {}", in_words(window), path),
              fmt::format("the terrain reaches from {}", in_words(extent)));
}

std::optional<Box2> wanted_window(const ReadOptions& options, const MapFrame& map,
                                  const std::string& path) {
  if (!options.bbox_lonlat) return options.bbox;
  if (!is_on_earth(map.crs_wkt))
    throw Error(fmt::format("`bbox_lonlat`: {} has {}, so longitudes and latitudes aren't known",
                            path, map.crs_wkt.empty() ? "no CRS" : "a local CRS"),
                "give `bbox` in its own coordinates, or the file a CRS (gdal_edit.py -a_srs)");
  const auto window =
      map_bounds_of_lonlat(map.crs_wkt, *options.bbox_lonlat, whole_turn(map.crs_wkt));
  if (!window)
    throw Error(fmt::format("`bbox_lonlat` {} has places that aren't in the CRS of {}, {}",
                            in_words(*options.bbox_lonlat), path, map.crs_name),
                "longitudes come first, then latitudes: W,S,E,N; take a smaller window");
  return window;
}

std::string in_brief(const std::vector<std::string>& paths) {
  return paths.size() == 1 ? paths.front()
                           : fmt::format("{} and {} more", paths.front(), paths.size() - 1);
}

std::string in_command(const std::vector<std::string>& paths) {
  return paths.size() > 4 ? "FILES" : fmt::format("{}", fmt::join(paths, " "));
}

} // namespace orograph
