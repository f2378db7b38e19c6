// SPDX-License-Identifier: GPL-3.0-or-later
// Names above a panorama: over one line, with a leader down to each summit.
#pragma once

#include "draw/page_text.hpp"
#include "geometry/angle.hpp"
#include "geometry/box.hpp"
#include "geometry/vec.hpp"

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "naming/rank_names.hpp"

namespace orograph {

struct NameToPlace {
  Vec2 summit_mm;
  NameWeight weight; ///< above 0
  PageText text;     ///< set, wherever
  std::size_t strip = 0;
};

/// A straight line from a summit to its name.
struct Leader {
  Vec2 from_mm, to_mm;
};

struct PlacedName {
  std::size_t name; ///< number
  PageText text;    ///< its extent is that of its letters; to be set again on the page's step
  std::optional<Leader> leader = std::nullopt;
};

/// Where names of a strip may be, and the y of the highest line that is drawn of it between two
/// abscissae; infinity: of none.
struct StripRoom {
  Box2 box_mm;
  std::function<double(double, double)> highest_mm;
};

/// How much room a name may need above its strip and to its right. `longest_mm`: of all names.
struct RoomForNames {
  double above_mm = 0, right_mm = 0;
};
RoomForNames room_for_names(const TextExtent& longest, double size_mm, Angle angle, int rows);

/// Names that climb at an angle, each over its own summit, on one line for all of a strip that is
/// above the highest line beneath them: of the sets of at most `most` names in which none touches
/// another the one that counts most, exactly. Names for which their strip has no room are left out
/// before. REQUIRES an angle above 0, at most 90 degrees.
std::vector<PlacedName> names_slanted(std::span<const NameToPlace> names,
                                      std::span<const StripRoom> strips, Angle angle,
                                      std::optional<std::size_t> most);

/// Level names in up to `rows` rows: each, first those that count most, in the lowest row in which
/// it touches no other name and no leader, nor its leader another name.
std::vector<PlacedName> names_in_rows(std::span<const NameToPlace> names,
                                      std::span<const StripRoom> strips, int rows,
                                      std::optional<std::size_t> most);

} // namespace orograph
