// SPDX-License-Identifier: GPL-3.0-or-later
// What strokes tell of themselves in files tied to the ground.
#pragma once

#include "draw/drawing.hpp"
#include "geometry/attributes.hpp"

#include <array>
#include <string>
#include <string_view>

namespace orograph {

/// Their own fields, which every stroke has.
constexpr std::array<std::string_view, 6> kStrokeFields{"layer",   "profile", "depth",
                                                        "visible", "level",   "darkness"};
/// As simplestyle calls it, and programs that show GeoJSON: "#rrggbb". It is there where a layer of
/// the drawing has a colour of its own.
constexpr std::string_view kColourField = "stroke";

bool tells_colours(const Drawing& drawing);

/// What a field is called that stands for an attribute of what strokes are lines of: a name that
/// strokes' own fields have, or GeoPackage's, whatever its case, gets a mark.
std::string field_name(const std::string& attribute, bool with_colour);

/// In the fields' order; then the colour; then what the thing tells that the stroke is a line of,
/// if it is one. Not a number: the stroke has none.
Attributes attributes_of(const Stroke& stroke, const Layer& from, bool with_colour);

} // namespace orograph
