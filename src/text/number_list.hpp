// SPDX-License-Identifier: GPL-3.0-or-later
// Lists and ranges of numbers, as people write them.
#pragma once

#include "text/quantities.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace orograph {

/// The numbers of "0:360:5", from the first up (or down) to the last in steps, or "1,2,5", or of
/// both: "0:10:2,15". A range ends at the last number that doesn't pass its end. Its numbers are
/// rounded to twelve digits of the largest, so that steps of 0.1 stay numbers of one decimal. What
/// is no range is read by `parse`. Throws UsageError, which begins with the list's name, where
/// there is no number, a step is zero or leads away from the end, or there would be more than ten
/// million.
std::vector<double>
parse_number_list(const std::string& name, const std::string& text,
                  std::optional<double> (*parse)(std::string_view) = parse_number);

/// Twelve digits at most, as few as tell it.
std::string number_text(double number);

} // namespace orograph
