// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/options/option.hpp"

#include "geometry/error.hpp"
#include "text/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace orograph {
namespace {

bool is_word(std::string_view text) {
  return !text.empty() && text.find_first_not_of("abcdefghijklmnopqrstuvwxyz-") == text.npos;
}

} // namespace

std::vector<std::string> Option::words_to_choose() const {
  std::vector<std::string> all;
  for (std::string& part : split(value, '|'))
    if (is_word(part)) all.push_back(std::move(part));
  all.insert(all.end(), words.begin(), words.end());
  return all;
}

bool Option::is_choice() const {
  if (value == "FORMAT") return true; // any of `words`, in any case
  const std::vector<std::string> parts = split(value, '|');
  return std::all_of(parts.begin(), parts.end(), is_word);
}

bool is_among(std::string_view names, std::string_view name) {
  return std::ranges::count(split(names, ' '), name) > 0;
}

bool insists_on(const GivenOptions& given, std::string_view option) {
  const auto found = given.find(option);
  return found != given.end() && found->second.place.empty();
}

void refuse(const GivenOptions& given, std::string_view options, std::string_view where,
            std::string_view right) {
  for (const std::string& option : split(options, ' '))
    if (insists_on(given, option))
      throw UsageError(fmt::format("{} has no meaning {}", option, where), right);
}

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
  return std::string(unit) + (unit.empty() || limits.empty() ? "" : ", ") + limits;
}

} // namespace orograph
