// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/options/option_group.hpp"

#include "text/quantities.hpp"
#include "text/words.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace orograph {

OptionGroup& OptionGroup::value(std::string_view names, std::string_view help,
                                std::string_view allowed, std::string_view by_default, Take take) {
  Option option;
  option.group = heading_;
  if (names.size() > 3 && names[2] == ',') { // "-j, --jobs N"
    option.letter = names[1];
    names.remove_prefix(4);
  }
  const std::size_t end = std::min(names.find(' '), names.size());
  option.name = names.substr(0, end);
  if (end < names.size()) option.value = names.substr(end + 1);
  option.help = help;
  option.allowed = allowed;
  option.by_default = by_default;
  option.take = std::move(take);
  options_.push_back(std::move(option));
  return *this;
}

OptionGroup& OptionGroup::name(std::string_view names, std::string_view help,
                               std::string_view allowed, std::string_view by_default,
                               std::string& into) {
  return value(names, help, allowed, by_default, [&into](const std::string& text) {
    into = text;
    return !text.empty();
  });
}

OptionGroup& OptionGroup::text(std::string_view names, std::string_view help,
                               std::string_view by_default, std::string& into) {
  return value(names, help, {}, by_default, [&into](const std::string& text) {
    into = text;
    return true;
  });
}

OptionGroup& OptionGroup::number(std::string_view names, std::string_view help,
                                 const NumberRange& range, std::function<void(double)> store,
                                 std::string_view by_default) {
  value(names, help, range.describe(), by_default,
        [range, store = std::move(store)](const std::string& text) {
          const auto number = parse_number(text);
          if (!number || !range.holds(*number)) return false;
          store(*number);
          return true;
        });
  options_.back().range = range;
  return *this;
}

OptionGroup& OptionGroup::number(std::string_view names, std::string_view help,
                                 const NumberRange& range, double& into,
                                 std::string_view by_default) {
  return number(
      names, help, range, [&into](double x) { into = x; },
      by_default.empty() ? fmt::format("{}", into) : by_default);
}

OptionGroup& OptionGroup::number(std::string_view names, std::string_view help,
                                 const NumberRange& range, std::optional<double>& into,
                                 std::string_view by_default) {
  return number(
      names, help, range, [&into](double x) { into = x; }, by_default);
}

OptionGroup& OptionGroup::number(std::string_view names, std::string_view help,
                                 const NumberRange& range, Angle& into,
                                 std::string_view by_default) {
  return number(
      names, help, range, [&into](double x) { into = Angle::degrees(x); }, by_default);
}

OptionGroup& OptionGroup::number(std::string_view names, std::string_view help,
                                 const NumberRange& range, std::optional<Angle>& into,
                                 std::string_view by_default) {
  return number(
      names, help, range, [&into](double x) { into = Angle::degrees(x); }, by_default);
}

OptionGroup& OptionGroup::whole(std::string_view names, std::string_view help, int low, int high,
                                std::function<void(int)> store, std::string_view by_default) {
  const bool has_end = high != std::numeric_limits<int>::max();
  value(names, help,
        has_end ? fmt::format("a whole number, {} to {}", low, high)
                : fmt::format("a whole number, at least {}", low),
        by_default, [low, high, store = std::move(store)](const std::string& text) {
          const auto number = parse_integer(text);
          if (!number || *number < low || *number > high) return false;
          store(*number);
          return true;
        });
  NumberRange& range = options_.back().range.emplace();
  range.low = low;
  if (has_end) range.high = high;
  options_.back().is_whole = true;
  return *this;
}

OptionGroup& OptionGroup::whole(std::string_view names, std::string_view help, int low, int high,
                                int& into, std::string_view by_default) {
  return whole(
      names, help, low, high, [&into](int n) { into = n; },
      by_default.empty() ? std::to_string(into) : by_default);
}

OptionGroup& OptionGroup::whole(std::string_view names, std::string_view help, int low, int high,
                                std::optional<int>& into, std::string_view by_default) {
  return whole(
      names, help, low, high, [&into](int n) { into = n; }, by_default);
}

OptionGroup& OptionGroup::one_of(std::string_view names, std::string_view help,
                                 std::vector<std::string_view> words, std::string_view by_default,
                                 std::function<void(std::size_t)> store) {
  const std::string placeholder = joined(words, "|");
  value(names, help, {}, by_default,
        [words = std::move(words), store = std::move(store)](const std::string& text) {
          const auto found = std::find(words.begin(), words.end(), text);
          if (found == words.end()) return false;
          store(static_cast<std::size_t>(found - words.begin()));
          return true;
        });
  options_.back().value = placeholder;
  return *this;
}

OptionGroup& OptionGroup::if_alone(std::string_view value) {
  options_.back().if_alone = value;
  return *this;
}

OptionGroup& OptionGroup::repeatable() {
  options_.back().repeatable = true;
  return *this;
}

OptionGroup& OptionGroup::words(std::vector<std::string> words) {
  options_.back().words = std::move(words);
  return *this;
}

OptionGroup& OptionGroup::files(std::vector<std::string> extensions) {
  options_.back().extensions = std::move(extensions);
  return *this;
}

OptionGroup& OptionGroup::between(char separator) {
  options_.back().between = separator;
  return *this;
}

} // namespace orograph
