// SPDX-License-Identifier: GPL-3.0-or-later
// The values of options, from text.
#include "cli/options/option_values.hpp"

#include "text/words.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <utility>

namespace orograph {
namespace {

template <typename Number>
std::optional<Number> parse_whole(std::string_view text) {
  // from_chars knows no leading plus, and people write one.
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  Number value{};
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || stop != end) return std::nullopt;
  return value;
}

/// As many numbers as asked for, with the separator between them.
std::optional<std::vector<double>> parse_numbers(std::string_view text, char separator,
                                                 std::size_t count) {
  const auto parts = split(text, separator);
  if (parts.size() != count) return std::nullopt;
  std::vector<double> numbers;
  for (const auto& part : parts) {
    const auto number = parse_number(part);
    if (!number) return std::nullopt;
    numbers.push_back(*number);
  }
  return numbers;
}

} // namespace

std::optional<double> parse_number(std::string_view text) {
  const auto value = parse_whole<double>(text);
  if (!value || !std::isfinite(*value)) return std::nullopt;
  return value;
}

std::optional<int> parse_integer(std::string_view text) {
  return parse_whole<int>(text);
}

std::optional<GivenPlace> parse_place(std::string_view text) {
  if (const auto n = parse_numbers(text, ',', 2)) return GivenPlace((*n)[0], (*n)[1]);
  if (const auto n = parse_numbers(text, ',', 3)) return GivenPlace({(*n)[0], (*n)[1], (*n)[2]});
  return std::nullopt;
}

std::optional<Box2> parse_box(std::string_view text) {
  const auto n = parse_numbers(text, ',', 4);
  if (!n || !((*n)[0] < (*n)[2] && (*n)[1] < (*n)[3])) return std::nullopt;
  return Box2{{(*n)[0], (*n)[1]}, {(*n)[2], (*n)[3]}};
}

std::optional<Box2> parse_lonlat_box(std::string_view text) {
  const auto n = parse_numbers(text, ',', 4);
  if (!n) return std::nullopt;
  Box2 box{{(*n)[0], (*n)[1]}, {(*n)[2], (*n)[3]}};
  if (std::abs(box.low.x) > 360 || std::abs(box.high.x) > 360) return std::nullopt;
  if (box.low.y < -90 || box.high.y > 90 || !(box.low.y < box.high.y)) return std::nullopt;
  if (box.high.x < box.low.x) box.high.x += 360;
  if (!(box.width() > 0 && box.width() <= 360)) return std::nullopt;
  return box;
}

std::optional<double> parse_compass_deg(std::string_view text) {
  constexpr std::array<std::string_view, 16> kRose{"n",  "nne", "ne", "ene", "e",  "ese",
                                                   "se", "sse", "s",  "ssw", "sw", "wsw",
                                                   "w",  "wnw", "nw", "nnw"};
  const auto* const found = std::ranges::find(kRose, in_lower_case(text));
  if (found == kRose.end()) return std::nullopt;
  return 22.5 * static_cast<double>(found - kRose.begin());
}

std::optional<double> parse_azimuth_deg(std::string_view text) {
  const auto by_name = parse_compass_deg(text);
  return by_name ? by_name : parse_number(text);
}

std::optional<ViewFrom> parse_view_from(std::string_view text) {
  const auto parts = split(text, '/');
  if (parts.size() != 2) return std::nullopt;
  const auto azimuth = parse_azimuth_deg(parts[0]), elevation = parse_number(parts[1]);
  if (!azimuth || !elevation || *elevation < -90 || *elevation > 90) return std::nullopt;
  return ViewFrom{Angle::degrees(*azimuth), Angle::degrees(*elevation)};
}

std::optional<LineWidths> parse_pen_width(std::string_view text) {
  const auto is_width = [](double mm) { return mm >= 0.01 && mm <= 10; };
  if (const auto one = parse_number(text); one && is_width(*one)) return LineWidths{*one, *one};
  const auto n = parse_numbers(text, ':', 2);
  if (!n || !is_width((*n)[0]) || !is_width((*n)[1]) || !((*n)[0] < (*n)[1])) return std::nullopt;
  return LineWidths{(*n)[0], (*n)[1]};
}

std::optional<LightSpec> parse_light(std::string_view text) {
  LightSpec light;
  if (text == "picture") return light;
  const auto from = parse_view_from(text);
  if (!from || from->elevation < Angle()) return std::nullopt;
  light.of_picture = false;
  light.azimuth = from->azimuth;
  light.altitude = from->elevation;
  return light;
}

std::optional<Oblique> parse_oblique(std::string_view text) {
  if (text == "cavalier") return kCavalier;
  if (text == "cabinet") return kCabinet;
  if (text == "military") return kMilitary;
  const auto n = parse_numbers(text, ',', 2);
  if (!n || !((*n)[0] > 0) || (*n)[1] < 0 || (*n)[1] > 180) return std::nullopt;
  return Oblique{(*n)[0], Angle::degrees((*n)[1])};
}

std::optional<ViewFrom> axonometric_view(std::string_view text) {
  // The eye's elevation e and its azimuth a beside the map's south axis shorten the three axes by
  // sqrt(1 - cos² e sin² a), sqrt(1 - cos² e cos² a) and cos e.
  if (text == "isometric") return ViewFrom{Angle::degrees(225), atan2_angle(1, std::sqrt(2))};
  if (text == "dimetric") // cos e = sqrt(8)/3 for across and up, half of it in depth
    return ViewFrom{Angle::degrees(180) + atan2_angle(1, std::sqrt(7)),
                    atan2_angle(1, std::sqrt(8))};
  if (text == "trimetric") return ViewFrom{Angle::degrees(210), Angle::degrees(25)};
  return std::nullopt;
}

std::optional<PlanRequest> parse_spacing(std::string_view text) {
  const bool on_page = text.ends_with("mm");
  if (!on_page && !text.ends_with("m")) return std::nullopt;
  text.remove_suffix(on_page ? 2 : 1);
  const auto length = parse_number(text);
  if (!length || *length <= 0) return std::nullopt;
  if (on_page) return PageSpacing{*length};
  return GroundSpacing{*length};
}

std::optional<double> parse_metres(std::string_view text) {
  if (text.ends_with("mm") || !text.ends_with("m")) return std::nullopt;
  text.remove_suffix(1);
  const auto length = parse_number(text);
  if (!length || *length < 0) return std::nullopt;
  return length;
}

std::optional<std::uint64_t> parse_bytes(std::string_view text) {
  constexpr std::array<std::pair<std::string_view, double>, 3> kUnits{
      {{"kB", 1e3}, {"MB", 1e6}, {"GB", 1e9}}};
  for (const auto& [unit, bytes] : kUnits) {
    if (!text.ends_with(unit)) continue;
    text.remove_suffix(unit.size());
    const auto number = parse_number(text);
    constexpr double kMost = 1e18; // as many as an integer holds
    if (!number || !(*number >= 0) || *number * bytes > kMost) return std::nullopt;
    return static_cast<std::uint64_t>(*number * bytes);
  }
  return std::nullopt;
}

std::optional<GivenHeights> parse_heights(std::string_view text) {
  constexpr double kFoot_m = 0.3048;
  GivenHeights out;
  if (text.ends_with("ft")) {
    out.unit_m = kFoot_m;
    text.remove_suffix(2);
  } else if (text.ends_with("m")) {
    out.unit_m = 1;
    text.remove_suffix(1);
  }
  for (const std::string& part : split(text, ',')) {
    const auto height = parse_number(part);
    if (!height) return std::nullopt;
    out.values.push_back(*height);
  }
  return out;
}

std::optional<double> parse_arc_deg(std::string_view text) {
  double unit_deg = 1;
  for (; text.ends_with('\''); text.remove_suffix(1)) unit_deg /= 60;
  const auto arc = parse_number(text);
  if (!arc || *arc < 0 || unit_deg < 1.0 / 3601) return std::nullopt;
  return *arc * unit_deg;
}

std::optional<PageSize> parse_page_size(std::string_view text) {
  const auto parts = split(text, 'x');
  if (parts.size() != 2) return std::nullopt;
  const auto side = [](std::string_view part) {
    const auto mm = parse_number(part);
    return mm && *mm >= 1 && *mm <= 10000 ? mm : std::nullopt;
  };
  const auto width_mm = side(parts[0]), height_mm = side(parts[1]);
  if (!width_mm || (!height_mm && in_lower_case(parts[1]) != "auto")) return std::nullopt;
  return PageSize{*width_mm, height_mm};
}

std::optional<SheetsRequest> parse_sheets(std::string_view text) {
  const auto parts = split(text, 'x');
  if (parts.size() != 2) return std::nullopt;
  const auto columns = parse_integer(parts[0]), rows = parse_integer(parts[1]);
  const auto is_few = [](std::optional<int> n) { return n && *n >= 1 && *n <= 20; };
  if (!is_few(columns) || !is_few(rows)) return std::nullopt;
  return SheetsRequest{.columns = *columns, .rows = *rows};
}

std::optional<Vec2> parse_range(std::string_view text) {
  const auto parts = split(text, ':');
  if (parts.size() != 2) return std::nullopt;
  const auto from = parse_number(parts[0]), to = parse_number(parts[1]);
  if (!from || !to) return std::nullopt;
  return Vec2{*from, *to};
}

std::optional<double> parse_scale(std::string_view text) {
  if (text.starts_with("1:")) text.remove_prefix(2);
  const auto scale = parse_number(text);
  return scale && *scale > 0 ? scale : std::nullopt;
}

// A file may have colons in its own name.
OverlayInput parse_overlay(const std::string& text) {
  const std::size_t colon = text.rfind(':');
  std::error_code ignored;
  if (colon == std::string::npos || colon == 0 || std::filesystem::exists(text, ignored) ||
      text.find('/', colon) != std::string::npos)
    return {.path = text};
  return {.path = text.substr(0, colon), .layer = text.substr(colon + 1)};
}

std::vector<std::string> split(std::string_view text, char separator) {
  std::vector<std::string> parts;
  for (;;) {
    const auto at = text.find(separator);
    parts.emplace_back(text.substr(0, at));
    if (at == std::string_view::npos) return parts;
    text.remove_prefix(at + 1);
  }
}

} // namespace orograph
