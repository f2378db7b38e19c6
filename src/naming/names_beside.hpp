// SPDX-License-Identifier: GPL-3.0-or-later
// Names of summits on a map: level, each beside its summit.
#pragma once

#include "geometry/box.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "naming/ink_map.hpp"
#include "naming/names_above.hpp"
#include "naming/taken_room.hpp"

namespace orograph {

/// How far the mark on a summit may reach from it.
constexpr double kSummitMark_mm = 0.8;

/// Names, first those that count most, each in the best free one of eight places about its summit:
/// where fewest lines are beneath it, and among such first above, then to the upper right, upper
/// left, right, left, below. None touches what is taken, another name, or the summit of a name that
/// is chosen already; all are within the room. What they take is added. At most `most`;
/// if none is given, until they cover a sixteenth of the room.
std::vector<PlacedName> names_beside(std::span<const NameToPlace> names, const Box2& room_mm,
                                     const InkMap& ink, std::optional<std::size_t> most,
                                     TakenRoom& taken);

} // namespace orograph
