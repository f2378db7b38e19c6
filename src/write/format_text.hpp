// SPDX-License-Identifier: GPL-3.0-or-later
// Coordinates, and text from the user, as files hold them.
#pragma once

#include "draw/drawing.hpp"

#include <cstddef>
#include <string>
#include <string_view>

namespace orograph {

/// Room that any number may need: 309 digits, a sign, a point and 4 decimals.
constexpr std::size_t kPageNumberBytes = 320;

/// Prints with 4 decimals, trailing zeros trimmed: what `std::to_chars` gives in fixed notation, to
/// the byte, but several times as quickly for numbers on `kPageStep_mm`. Returns the text's end;
/// nothing marks it. REQUIRES kPageNumberBytes at `to`, and a finite number.
char* print_page_number(double value_mm, char* to);
/// The same as a text.
std::string page_number(double value_mm);

/// The text as valid UTF-8 that XML 1.0 may hold: bytes that are not UTF-8, and control characters
/// other than tab and line breaks, become U+FFFD.
std::string clean_utf8(std::string_view text);

/// `clean_utf8` with the characters escaped that mean something in XML text or attributes.
std::string xml_escaped(std::string_view text);

/// "#rrggbb", of its ink or else its grey.
std::string hex_colour(const Layer& layer);

} // namespace orograph
