// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/options/option_values.hpp"

#include "text/quantities.hpp"
#include "text/words.hpp"

#include <cmath>
#include <filesystem>

namespace orograph {
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

// A file may have colons in its own name.
OverlayInput parse_overlay(const std::string& text) {
  const std::size_t colon = text.rfind(':');
  std::error_code ignored;
  if (colon == std::string::npos || colon == 0 || std::filesystem::exists(text, ignored) ||
      text.find('/', colon) != std::string::npos)
    return {.path = text};
  return {.path = text.substr(0, colon), .layer = text.substr(colon + 1)};
}

} // namespace orograph
