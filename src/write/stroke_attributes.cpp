// SPDX-License-Identifier: GPL-3.0-or-later
#include "write/stroke_attributes.hpp"

#include "text/words.hpp"
#include "write/format_text.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace orograph {

bool tells_colours(const Drawing& drawing) {
  return std::ranges::any_of(drawing.layers,
                             [](const Layer& layer) { return layer.ink().has_value(); });
}

std::string field_name(const std::string& attribute, bool with_colour) {
  const std::string lower = in_lower_case(attribute);
  const auto is_called = [&](std::string_view name) { return name == lower; };
  const bool is_own = std::ranges::any_of(kStrokeFields, is_called) || is_called("fid") ||
                      is_called("geom") || (with_colour && is_called(kColourField));
  return is_own ? attribute + "_" : attribute;
}

Attributes attributes_of(const Stroke& stroke, const Layer& from, bool with_colour) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  const auto whole = [](std::int64_t value) { return AttributeValue(value); };
  Attributes out;
  const auto add = [&](std::string_view name, AttributeValue value) {
    out.push_back({std::string(name), std::move(value)});
  };
  add("layer", from.name);
  add("profile", whole(stroke.profile));
  add("depth", stroke.depth_m);
  add("visible", whole(from.is_hidden ? 0 : 1));
  add("level", stroke.profile < 0 ? AttributeValue(none) : whole(stroke.level));
  add("darkness", std::round(1e4 * static_cast<double>(stroke.darkness)) / 1e4);
  if (with_colour) add(kColourField, hex_colour(from));
  if (stroke.feature >= 0)
    for (const auto& [name, value] : from.features[static_cast<std::size_t>(stroke.feature)])
      add(field_name(name, with_colour), value);
  return out;
}

} // namespace orograph
