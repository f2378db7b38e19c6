// SPDX-License-Identifier: GPL-3.0-or-later
// What became of names, a line on stderr and a part of the report; and of furniture.
#pragma once

#include "map/map_facts.hpp"

#include <string>

namespace orograph {

/// "12 of 61 names, 30 hidden, 19 without room, 4 beyond the picture".
std::string names_in_words(const NamesFacts& names);

/// A JSON object: lists of the names that are chosen, crowded out and hidden, the first that counts
/// most, hidden ones from the highest on; and numbers of others.
std::string names_as_json(const NamesFacts& names);

/// A JSON object of what stands around the picture: pieces with their boxes, left, top, right and
/// bottom in mm, and texts, those that are cut whole as well; pieces without a place; and what
/// letters there were none of.
std::string furniture_as_json(const MapFacts& facts);

} // namespace orograph
