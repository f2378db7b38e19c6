// SPDX-License-Identifier: GPL-3.0-or-later
// Kinds of options: each gives an `Option` its `take`, and the words of `allowed` that say the
// same.
#pragma once

#include "cli/options/option.hpp"

#include <algorithm>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace orograph {

struct NumberRange {
  std::string unit = {}; ///< empty for a plain number
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool low_excluded = false, high_excluded = false;

  bool holds(double x) const {
    return (low_excluded ? x > low : x >= low) && (high_excluded ? x < high : x <= high);
  }
  /// "degrees, above 0 and below 180".
  std::string describe() const;
};

/// A finite number in the range, kept by `store`.
Option with_number(Option option, const NumberRange& range, std::function<void(double)> store);

/// A whole number from `low` to `high`; where `high` is the largest there is, it isn't spoken of.
Option with_integer(Option option, int low, int high, std::function<void(int)> store);

/// One word of a few: "surface|profiles". The references that options keep must outlive them.
template <typename Value>
Option with_choice(Option option, std::vector<std::pair<std::string, Value>> choices, Value& into) {
  option.value.clear();
  for (const auto& choice : choices)
    option.value += (option.value.empty() ? "" : "|") + choice.first;
  option.take = [choices = std::move(choices), &into](const std::string& text) {
    const auto found = std::find_if(choices.begin(), choices.end(),
                                    [&](const auto& choice) { return choice.first == text; });
    if (found == choices.end()) return false;
    into = found->second;
    return true;
  };
  return option;
}

/// What `parse` makes of the text, if it makes anything of it.
template <typename Parse, typename Into>
std::function<bool(const std::string&)> stored(Parse parse, Into& into) {
  return [parse, &into](const std::string& text) {
    const auto value = parse(text);
    if (!value) return false;
    into = *value;
    return true;
  };
}

/// For switches: `into` becomes `to`.
template <typename Value, typename To>
std::function<bool(const std::string&)> set_to(Value& into, To to) {
  return [&into, to](const std::string&) {
    into = to;
    return true;
  };
}

/// A name that isn't empty.
std::function<bool(const std::string&)> stored_name(std::string& into);

} // namespace orograph
