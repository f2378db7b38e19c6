// SPDX-License-Identifier: GPL-3.0-or-later
// A page coordinate as text.
#pragma once

#include <cstddef>

namespace orograph {

/// Room that any number may need: 309 digits, a sign, a point and 4 decimals.
constexpr std::size_t kPageNumberBytes = 320;

/// Prints with 4 decimals, trailing zeros trimmed: what `std::to_chars` gives in fixed notation, to
/// the byte, but several times as quickly for numbers on `kPageStep_mm`. Returns the text's end;
/// nothing marks it. REQUIRES kPageNumberBytes at `to`, and a finite number.
char* print_page_number(double value_mm, char* to);

} // namespace orograph
