// SPDX-License-Identifier: GPL-3.0-or-later
// Lines and points of a map, without heights, to be laid over a terrain.
#pragma once

#include "geometry/attributes.hpp"
#include "geometry/vec.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace orograph {

/// Places are in the coordinates of the terrain's map.
struct Overlay {
  /// One thing of the map, with some of the lines, or with points alone; of one without a place, no
  /// line.
  struct Feature {
    Attributes attributes;
    std::size_t first_line, line_count;
  };
  /// Some of the places: one alone is a point, and none a place that the terrain's CRS doesn't
  /// have. A closed line has its first place again as its last.
  struct Line {
    std::size_t first_place, place_count;
  };

  std::string source; ///< file and layer, for messages
  std::vector<Vec2> places;
  std::vector<Line> lines;
  std::vector<Feature> features;
  std::vector<std::string> fields; ///< that attributes may have; one without a value isn't there
  std::vector<std::string> notes;  ///< what its reader assumed, a sentence each
};

} // namespace orograph
