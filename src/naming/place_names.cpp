// SPDX-License-Identifier: GPL-3.0-or-later
#include "naming/place_names.hpp"

#include "geometry/error.hpp"
#include "placing/overlay_points.hpp"
#include "text/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <tuple>
#include <variant>

namespace orograph {
namespace {

constexpr double kFoot_m = 0.3048;

// As OpenStreetMap, GeoNames, GPX and lists of summits have them.
constexpr std::array<std::string_view, 12> kHeights{
    "ele",    "elevation",    "ele_m",  "elevation_m", "elev",      "elev_m",
    "ele_ft", "elevation_ft", "height", "height_m",    "height_ft", "altitude"};

std::string text_of(const Attribute& attribute) {
  if (const auto* text = std::get_if<std::string>(&attribute.value)) {
    constexpr std::string_view blanks = " \t\r\n";
    const std::size_t first = text->find_first_not_of(blanks);
    if (first == std::string::npos) return {};
    return text->substr(first, text->find_last_not_of(blanks) + 1 - first);
  }
  if (const auto* whole = std::get_if<std::int64_t>(&attribute.value))
    return fmt::format("{}", *whole);
  return fmt::format("{}", std::get<double>(attribute.value));
}

struct Measure {
  double value;
  std::string unit; ///< in lower case; empty: none
};

// "4808", "4808.0m", "15 774 ft" without the blank in the number.
std::optional<Measure> measure_of(const Attribute& attribute) {
  std::string text = text_of(attribute);
  const std::size_t end = std::min(text.find_first_not_of("+-.0123456789"), text.size());
  const auto value = number_of<double>(std::string_view(text).substr(0, end));
  if (!value || !std::isfinite(*value)) return std::nullopt;
  std::string_view rest = std::string_view(text).substr(end);
  return Measure{*value, in_lower_case(next_word(rest))};
}

std::optional<double> metres_of(const Attribute& attribute) {
  const auto measure = measure_of(attribute);
  if (!measure) return std::nullopt;
  const bool is_feet = measure->unit.starts_with("f") || measure->unit == "'" ||
                       (measure->unit.empty() && in_lower_case(attribute.name).ends_with("_ft"));
  return measure->value * (is_feet ? kFoot_m : 1);
}

const Attribute* find(const Attributes& attributes, std::string_view name) {
  const auto found = std::ranges::find_if(
      attributes, [&](const Attribute& a) { return in_lower_case(a.name) == name; });
  return found == attributes.end() ? nullptr : &*found;
}

// The field as the overlay spells it.
void check_field(const Overlay& overlay, const std::string& field, const char* spec_field) {
  const std::string lower = in_lower_case(field);
  if (std::ranges::any_of(overlay.fields,
                          [&](const std::string& one) { return in_lower_case(one) == lower; }))
    return;
  throw Error(fmt::format("{} has no field {}", overlay.source, field),
              overlay.fields.empty()
                  ? "a file whose points have fields"
                  : fmt::format("one of {} as `{}`", joined(overlay.fields, ", "), spec_field));
}

} // namespace

std::string text_with_height(const std::string& name, double height_m, LabelElevation elevation) {
  switch (elevation) {
  case LabelElevation::none:
    break;
  case LabelElevation::metres:
    return fmt::format("{} {:.0f} m", name, height_m);
  case LabelElevation::feet:
    return fmt::format("{} {:.0f} ft", name, height_m / kFoot_m);
  }
  return name;
}

PlaceNames place_names(const Overlay& overlay, const LabelSpec& spec) {
  const std::string field = spec.field.empty() ? "name" : spec.field;
  check_field(overlay, field, "labels.field");
  if (!spec.weight_field.empty()) check_field(overlay, spec.weight_field, "labels.weight_field");
  const OverlayPoints points = points_of(overlay);
  PlaceNames out;
  for (std::size_t i = 0; i < points.feature_of.size(); ++i) {
    if (points.place_of[i] == OverlayPoints::kNone) continue;
    const Attributes& attributes = overlay.features[points.feature_of[i]].attributes;
    PlaceName place;
    place.map = points.places[points.place_of[i]];
    if (const Attribute* name = find(attributes, in_lower_case(field))) place.text = text_of(*name);
    if (place.text.empty()) {
      ++out.unnamed;
      continue;
    }
    for (const std::string_view height : kHeights)
      if (const Attribute* own = place.height_m ? nullptr : find(attributes, height))
        place.height_m = metres_of(*own);
    if (const Attribute* own = find(attributes, "prominence")) place.prominence_m = metres_of(*own);
    if (!spec.weight_field.empty())
      if (const Attribute* own = find(attributes, in_lower_case(spec.weight_field)))
        if (const auto measure = measure_of(*own)) place.weight = measure->value;
    out.places.push_back(std::move(place));
  }
  const auto key = [](const PlaceName& place) {
    return std::tuple(place.map.x, place.map.y, std::string_view(place.text),
                      place.height_m.value_or(-1e300), place.prominence_m.value_or(-1e300),
                      place.weight.value_or(-1e300));
  };
  std::ranges::sort(out.places, [&](const PlaceName& a, const PlaceName& b) {
    return key(a) > key(b); // so that of two alike the one that says most is first
  });
  const auto rest = std::ranges::unique(out.places, [](const PlaceName& a, const PlaceName& b) {
    return a.map == b.map && a.text == b.text;
  });
  out.places.erase(rest.begin(), rest.end());
  return out;
}

} // namespace orograph
