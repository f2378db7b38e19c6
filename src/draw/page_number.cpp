// SPDX-License-Identifier: GPL-3.0-or-later
#include "draw/page_number.hpp"

#include <charconv>
#include <cmath>
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

} // namespace orograph
