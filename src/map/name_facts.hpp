// SPDX-License-Identifier: GPL-3.0-or-later
// What became of the names that a map was given.
#pragma once

#include "geometry/vec.hpp"
#include "map/place_sight.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace orograph {

enum class NameState {
  chosen,
  hidden,     ///< its summit isn't seen
  crowded_out ///< others that count more, or the page's end, leave it no room
};

/// One that is within the picture and its range.
struct NameFacts {
  std::string text; ///< as printed, but for what is cut off
  NameState state = NameState::chosen;
  Vec2 map;                       ///< its summit: a vertex of the terrain, in map coordinates
  double height = 0;              ///< of that, in the unit of the terrain's heights
  std::optional<Bearing> bearing; ///< of views with an eye
  double hidden_mm = 0; ///< how far under what hides it, on the page, at least; 0 where it is seen
  std::optional<std::array<Vec2, 4>> corners_mm = {}; ///< of its text, where it is printed
  std::optional<double> prominence_m;  ///< the file's, or else the terrain's; none: not asked
  bool prominence_is_at_least = false; ///< the terrain ends before it is known
};

struct NamesFacts {
  std::vector<NameFacts> names; ///< chosen, crowded out and hidden ones, each the first first
  std::size_t elsewhere = 0; ///< beyond the picture, the range or the terrain, or where the eye is
  std::size_t unnamed = 0;   ///< places of the file without a name

  std::size_t count(NameState state) const;
  std::string chosen() const; ///< their texts, with "; " between
};

} // namespace orograph
