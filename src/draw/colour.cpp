// SPDX-License-Identifier: GPL-3.0-or-later
#include "draw/colour.hpp"

#include "geometry/error.hpp"
#include "text/printable.hpp"
#include "text/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace orograph {
namespace {

struct NamedColour {
  std::string_view name;
  std::uint32_t value;
};
// CSS has 148: these are its basic ones, and inks of maps.
constexpr auto kColours = std::to_array<NamedColour>(
    {{"aqua", 0x00ffff},        {"black", 0x000000},        {"blue", 0x0000ff},
     {"brown", 0xa52a2a},       {"chocolate", 0xd2691e},    {"crimson", 0xdc143c},
     {"cyan", 0x00ffff},        {"darkblue", 0x00008b},     {"darkgreen", 0x006400},
     {"darkred", 0x8b0000},     {"dimgrey", 0x696969},      {"firebrick", 0xb22222},
     {"forestgreen", 0x228b22}, {"fuchsia", 0xff00ff},      {"gold", 0xffd700},
     {"gray", 0x808080},        {"green", 0x008000},        {"grey", 0x808080},
     {"indigo", 0x4b0082},      {"lime", 0x00ff00},         {"magenta", 0xff00ff},
     {"maroon", 0x800000},      {"midnightblue", 0x191970}, {"navy", 0x000080},
     {"olive", 0x808000},       {"orange", 0xffa500},       {"peru", 0xcd853f},
     {"pink", 0xffc0cb},        {"purple", 0x800080},       {"red", 0xff0000},
     {"royalblue", 0x4169e1},   {"saddlebrown", 0x8b4513},  {"sienna", 0xa0522d},
     {"silver", 0xc0c0c0},      {"slategrey", 0x708090},    {"steelblue", 0x4682b4},
     {"tan", 0xd2b48c},         {"teal", 0x008080},         {"tomato", 0xff6347},
     {"violet", 0xee82ee},      {"white", 0xffffff},        {"yellow", 0xffff00}});

constexpr auto kNames = [] {
  std::array<std::string_view, kColours.size()> names;
  for (std::size_t i = 0; i < names.size(); ++i) names[i] = kColours[i].name;
  return names;
}();

std::optional<Colour> of_digits(std::string_view text) {
  Colour colour{};
  if (text.size() != 7 || text[0] != '#') return std::nullopt;
  for (std::size_t i = 0; i < colour.size(); ++i) {
    const char* const begin = text.data() + 1 + 2 * i;
    if (std::from_chars(begin, begin + 2, colour[i], 16).ptr != begin + 2) return std::nullopt;
  }
  return colour;
}

} // namespace

Colour colour_of(std::string_view text) {
  if (const auto colour = of_digits(text)) return *colour;
  const std::string name = in_lower_case(text);
  const auto named = std::ranges::find(kNames, name);
  if (named == kNames.end()) {
    const std::string_view nearest = nearest_word(name, kNames);
    throw UsageError(fmt::format("there is no colour '{}'", printable(text)),
                     nearest.empty() || text.starts_with('#')
                         ? "give red, green and blue in hexadecimal digits, as in #8b5a2b, or a "
                           "name such as brown, blue or darkred"
                         : fmt::format("did you mean {}?", nearest));
  }
  const std::uint32_t value = kColours[static_cast<std::size_t>(named - kNames.begin())].value;
  return {static_cast<std::uint8_t>(value >> 16), static_cast<std::uint8_t>(value >> 8 & 0xff),
          static_cast<std::uint8_t>(value & 0xff)};
}

std::string hex_of(const Colour& colour) {
  return fmt::format("#{:02x}{:02x}{:02x}", colour[0], colour[1], colour[2]);
}

std::span<const std::string_view> colour_names() {
  return kNames;
}

} // namespace orograph
