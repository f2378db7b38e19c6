// SPDX-License-Identifier: GPL-3.0-or-later
// Colours of ink.
#pragma once

#include "geometry/api.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace orograph {

/// Red, green and blue of sRGB.
using Colour = std::array<std::uint8_t, 3>;

constexpr bool is_grey(const Colour& colour) {
  return colour[0] == colour[1] && colour[1] == colour[2];
}

/// "#rrggbb", or one of `colour_names`, in letters of either case. Throws UsageError, for other
/// texts, with the name that may have been meant or what would be right.
OROGRAPH_API Colour colour_of(std::string_view text);

/// "#rrggbb", in lower case.
OROGRAPH_API std::string hex_of(const Colour& colour);

/// Those that CSS has too, in the order of the alphabet.
OROGRAPH_API std::span<const std::string_view> colour_names();

} // namespace orograph
