// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers and quantities with units, as people write them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace orograph {

// Each of these reads the whole text, in the same way under every locale (a point, never a decimal
// comma; exponents and a leading plus are allowed), and returns nothing where the text isn't that
// kind of value. NaN, infinities and numbers too large for a double are no numbers.

std::optional<double> parse_number(std::string_view text);
std::optional<int> parse_integer(std::string_view text);
/// As many as asked for, with the separator between them.
std::optional<std::vector<double>> parse_numbers(std::string_view text, char separator,
                                                 std::size_t count);

/// Degrees, or one of the 16 directions of a compass rose in any letter case: "N", "nw", "NNE".
std::optional<double> parse_azimuth_deg(std::string_view text);
/// The same where only a name will do.
std::optional<double> parse_compass_deg(std::string_view text);

/// "2m", from 0 on.
std::optional<double> parse_metres(std::string_view text);

/// A number of bytes with kB, MB or GB, from 0 on.
std::optional<std::uint64_t> parse_bytes(std::string_view text);

/// Numbers with commas between, and behind the last one the unit of all: "m", "ft", or none, which
/// is the file's own.
struct GivenHeights {
  std::vector<double> values;
  std::optional<double> unit_m;
};
std::optional<GivenHeights> parse_heights(std::string_view text);

/// Degrees, or minutes "10'", or seconds "30''", from 0 on.
std::optional<double> parse_arc_deg(std::string_view text);

/// "1:25000", or the number alone, above 0: how much smaller the page is.
std::optional<double> parse_scale(std::string_view text);

} // namespace orograph
