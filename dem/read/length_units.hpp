// SPDX-License-Identifier: GPL-3.0-or-later
// Units of length by name, as files write them.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace orograph {

struct LengthUnit {
  const char* name; ///< for people
  double metres;
};

/// In whatever spelling, upper or lower case; none if it isn't a unit that we know.
std::optional<LengthUnit> length_unit(std::string_view written);

/// The name of a unit; its metres if it has none that we know.
std::string unit_name(double unit_m);

} // namespace orograph
