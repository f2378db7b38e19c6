// SPDX-License-Identifier: GPL-3.0-or-later
// UTF-8 by the table of well-formed sequences in the Unicode standard (section 3.9).
#include "write/format_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace orograph {
namespace {

// A number below 10000.
struct FourDigits {
  std::array<char, 7> digits; // four; the rest is room to read
  std::uint8_t leading_zeros : 4, trailing_zeros : 4;
};
constexpr std::array<FourDigits, 10000> kFourDigits = [] {
  std::array<FourDigits, 10000> all{};
  for (std::size_t i = 0; i < all.size(); ++i) {
    std::size_t rest = i;
    for (std::size_t k = 4; k-- > 0; rest /= 10)
      all[i].digits[k] = static_cast<char>('0' + rest % 10);
    std::uint8_t leading = 0, trailing = 0;
    while (leading < 4 && all[i].digits[leading] == '0') ++leading;
    while (trailing < 4 && all[i].digits[3U - trailing] == '0') ++trailing;
    all[i].leading_zeros = leading;
    all[i].trailing_zeros = trailing;
  }
  return all;
}();

char* without_trailing_zeros(char* end) {
  while (end[-1] == '0') --end;
  return end[-1] == '.' ? end - 1 : end;
}

} // namespace

char* print_page_number(double value_mm, char* to) {
  // Up to this many steps the product's rounding is far below the distance from a quarter to a
  // half, so that the exact decimal rounds to the same whole number of steps; and what is printed
  // has at most four digits before the point.
  constexpr double kMostSteps = 1e8 - 1;
  const double steps = std::abs(value_mm) * 1e4;
  const auto nearest = static_cast<std::uint32_t>(steps < kMostSteps ? steps + 0.5 : 0);
  if (!(std::abs(steps - static_cast<double>(nearest)) < 0.25))
    return without_trailing_zeros(
        std::to_chars(to, to + kPageNumberBytes, value_mm, std::chars_format::fixed, 4).ptr);

  // Without branches but for whole numbers: a general formatter took half of the writing.
  *to = '-';
  to += std::signbit(value_mm) ? 1 : 0;
  const std::uint32_t whole_mm = nearest / 10000, decimals = nearest % 10000;
  const FourDigits &before = kFourDigits[whole_mm], &behind = kFourDigits[decimals];
  const std::size_t zeros = std::min<std::size_t>(before.leading_zeros, 3);
  std::memcpy(to, before.digits.data() + zeros, 4);
  to += 4 - zeros;
  if (decimals == 0) return to;
  *to = '.';
  std::memcpy(to + 1, behind.digits.data(), 4);
  return to + 5 - behind.trailing_zeros;
}

namespace {

bool is_continuation(unsigned char byte) {
  return (byte & 0xC0) == 0x80;
}

bool is_xml_character(char32_t c) {
  return c == '\t' || c == '\n' || c == '\r' || (c >= 0x20 && c < 0xD800) ||
         (c >= 0xE000 && c < 0xFFFE) || (c >= 0x10000 && c < 0x110000);
}

// Bytes of the character that `text` begins with, 0 if it is none that XML may hold.
std::size_t length_of_character(std::string_view text) {
  const auto first = static_cast<unsigned char>(text[0]);
  const std::size_t length = first < 0x80                    ? 1
                             : first >= 0xC2 && first < 0xE0 ? 2
                             : first >= 0xE0 && first < 0xF0 ? 3
                             : first >= 0xF0 && first < 0xF5 ? 4
                                                             : 0;
  if (length == 0 || length > text.size()) return 0;
  char32_t character = length == 1 ? first : first & (0x7FU >> length);
  for (std::size_t i = 1; i < length; ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    if (!is_continuation(byte)) return 0;
    character = character << 6 | (byte & 0x3FU);
  }
  const bool is_overlong =
      (length == 3 && character < 0x800) || (length == 4 && character < 0x10000);
  return is_overlong || !is_xml_character(character) ? 0 : length;
}

} // namespace

std::string clean_utf8(std::string_view text) {
  std::string clean;
  while (!text.empty()) {
    const std::size_t length = length_of_character(text);
    clean += length == 0 ? "\xEF\xBF\xBD" : text.substr(0, length);
    text.remove_prefix(length == 0 ? 1 : length);
  }
  return clean;
}

std::string xml_escaped(std::string_view text) {
  std::string escaped;
  for (const char c : clean_utf8(text)) switch (c) {
    case '&':
      escaped += "&amp;";
      break;
    case '<':
      escaped += "&lt;";
      break;
    case '>':
      escaped += "&gt;";
      break;
    case '"':
      escaped += "&quot;";
      break;
    default:
      escaped += c;
    }
  return escaped;
}

std::string page_number(double value_mm) {
  std::array<char, kPageNumberBytes> text;
  return {text.data(), print_page_number(value_mm, text.data())};
}

std::string hex_colour(const Layer& layer) {
  const auto level = static_cast<std::uint8_t>(std::lround(255 * layer.grey));
  return hex_of(layer.ink().value_or(Colour{level, level, level}));
}

} // namespace orograph
