// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/quantities.hpp"

#include "text/words.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

namespace orograph {

std::optional<double> parse_number(std::string_view text) {
  const auto value = number_of<double>(text);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

std::optional<int> parse_integer(std::string_view text) {
  return number_of<int>(text);
}

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

std::optional<double> parse_scale(std::string_view text) {
  if (text.starts_with("1:")) text.remove_prefix(2);
  const auto scale = parse_number(text);
  return scale && *scale > 0 ? scale : std::nullopt;
}

} // namespace orograph
