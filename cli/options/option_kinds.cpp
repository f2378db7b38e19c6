// SPDX-License-Identifier: GPL-3.0-or-later
// Kinds of options.
#include "cli/options/option_kinds.hpp"

#include "cli/options/option_values.hpp"

#include <fmt/format.h>

#include <cmath>

namespace orograph {

std::string NumberRange::describe() const {
  std::string limits;
  if (std::isfinite(low) && std::isfinite(high) && !low_excluded && !high_excluded) {
    limits = fmt::format("{} to {}", low, high);
  } else {
    if (std::isfinite(low)) limits = fmt::format("{} {}", low_excluded ? "above" : "at least", low);
    if (std::isfinite(high))
      limits += fmt::format("{}{} {}", limits.empty() ? "" : " and ",
                            high_excluded ? "below" : "at most", high);
  }
  return unit + (unit.empty() || limits.empty() ? "" : ", ") + limits;
}

Option with_number(Option option, const NumberRange& range, std::function<void(double)> store) {
  option.allowed = range.describe();
  option.take = [range, store = std::move(store)](const std::string& text) {
    const auto number = parse_number(text);
    if (!number || !range.holds(*number)) return false;
    store(*number);
    return true;
  };
  return option;
}

Option with_integer(Option option, int low, int high, std::function<void(int)> store) {
  option.allowed = high == std::numeric_limits<int>::max()
                       ? fmt::format("a whole number, at least {}", low)
                       : fmt::format("a whole number, {} to {}", low, high);
  option.take = [low, high, store = std::move(store)](const std::string& text) {
    const auto number = parse_integer(text);
    if (!number || *number < low || *number > high) return false;
    store(*number);
    return true;
  };
  return option;
}

std::function<bool(const std::string&)> stored_name(std::string& into) {
  return [&into](const std::string& text) {
    into = text;
    return !text.empty();
  };
}

} // namespace orograph
