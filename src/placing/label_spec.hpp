// SPDX-License-Identifier: GPL-3.0-or-later
// What is asked of names and numbers on a map.
#pragma once

#include "geometry/angle.hpp"

#include <optional>
#include <string>

namespace orograph {

enum class LabelElevation { none, metres, feet };

/// Of the names of places, and of lines' labels. Sizes are on the page.
struct LabelSpec {
  std::string field;        ///< that holds names; empty: "name"
  std::string weight_field; ///< that says how much a place counts; empty: its shape on the ground
  std::optional<int> most;  ///< names
  std::optional<double> range_m;    ///< from an eye; none: three times the haze
  double haze_m = 120e3;            ///< over so far a summit comes to count e times less
  Angle angle = Angle::degrees(60); ///< of a panorama's names; 0: level, in rows
  int rows = 1;                     ///< of level names
  LabelElevation elevation = LabelElevation::none; ///< behind each name
  double size_mm = 2.5;                            ///< of letters, the em
  double halo_mm = 0.5;     ///< lines end so far from letters that stand on them
  bool contours = false;    ///< heights on index contours
  bool coordinates = false; ///< numbers at the ends of graticule and grid
};

} // namespace orograph
