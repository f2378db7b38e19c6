// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/printable.hpp"

#include <cstdint>

namespace orograph {
namespace {

bool goes_on(std::string_view text, std::size_t at) {
  return at < text.size() && (static_cast<unsigned char>(text[at]) & 0xC0U) == 0x80;
}

// The bytes of the character that begins at `at`; 0 where none does (RFC 3629, section 3).
std::size_t bytes_of_character(std::string_view text, std::size_t at) {
  const auto first = static_cast<unsigned char>(text[at]);
  if (first < 0x80) return 1;
  const std::size_t bytes = first < 0xC2   ? 0
                            : first < 0xE0 ? 2
                            : first < 0xF0 ? 3
                            : first < 0xF5 ? 4
                                           : 0;
  for (std::size_t i = 1; i < bytes; ++i)
    if (!goes_on(text, at + i)) return 0;
  if (bytes < 3) return bytes;
  const auto second = static_cast<unsigned char>(text[at + 1]);
  const bool too_long = (first == 0xE0 && second < 0xA0) || (first == 0xF0 && second < 0x90),
             surrogate = first == 0xED && second >= 0xA0,
             too_large = first == 0xF4 && second >= 0x90;
  return too_long || surrogate || too_large ? 0 : bytes;
}

// Controls of both sets, and what ends a line or a paragraph.
bool controls(std::string_view character) {
  if (character.size() == 1)
    return static_cast<unsigned char>(character[0]) < 0x20 || character[0] == 0x7f;
  return (character.size() == 2 && character < "\xC2\xA0") || character == "\xE2\x80\xA8" ||
         character == "\xE2\x80\xA9";
}

} // namespace

std::string printable(std::string_view text) {
  std::string line;
  line.reserve(text.size());
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t bytes = bytes_of_character(text, at);
    const std::string_view character = text.substr(at, bytes);
    if (bytes == 0 || controls(character))
      line += '?';
    else
      line += character;
    at += bytes == 0 ? 1 : bytes;
  }
  return line;
}

std::string shortened(std::string_view text, std::size_t most_bytes) {
  if (text.size() <= most_bytes) return std::string(text);
  constexpr std::string_view kGap = " … ";
  const std::size_t kept = most_bytes - kGap.size();
  // What is wrong stands first, what would be right last.
  std::size_t head = kept / 2, tail = text.size() - (kept - head);
  while (head > 0 && goes_on(text, head)) --head;
  while (goes_on(text, tail)) ++tail;
  return std::string(text.substr(0, head)).append(kGap).append(text.substr(tail));
}

} // namespace orograph
