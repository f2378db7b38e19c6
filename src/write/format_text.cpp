// SPDX-License-Identifier: GPL-3.0-or-later
// UTF-8 by the table of well-formed sequences in the Unicode standard (section 3.9).
#include "write/format_text.hpp"

#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace orograph {
namespace {

char* without_trailing_zeros(char* end) {
  while (end[-1] == '0') --end;
  return end[-1] == '.' ? end - 1 : end;
}

} // namespace

char* print_page_number(double value_mm, char* to) {
  // Up to this many steps the product's rounding is far below the distance from a quarter to a
  // half, so that the exact decimal rounds to the same whole number of steps.
  constexpr double kMostSteps = 1e13;
  const double steps = std::abs(value_mm) * 1e4;
  const auto nearest = static_cast<std::int64_t>(steps < kMostSteps ? steps + 0.5 : 0);
  if (!(std::abs(steps - static_cast<double>(nearest)) < 0.25))
    return without_trailing_zeros(
        std::to_chars(to, to + kPageNumberBytes, value_mm, std::chars_format::fixed, 4).ptr);

  if (std::signbit(value_mm)) *to++ = '-';
  const auto whole_mm = static_cast<std::uint64_t>(nearest) / 10000;
  const auto decimals = static_cast<std::uint32_t>(static_cast<std::uint64_t>(nearest) % 10000);
  to = std::to_chars(to, to + kPageNumberBytes - 1, whole_mm).ptr;
  if (decimals == 0) return to;
  to[0] = '.';
  to[1] = static_cast<char>('0' + decimals / 1000);
  to[2] = static_cast<char>('0' + decimals / 100 % 10);
  to[3] = static_cast<char>('0' + decimals / 10 % 10);
  to[4] = static_cast<char>('0' + decimals % 10);
  return without_trailing_zeros(to + 5);
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

} // namespace orograph
