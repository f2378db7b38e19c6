// SPDX-License-Identifier: GPL-3.0-or-later
// How a table of options is written: one after the other, each in the words of the help.
#pragma once

#include "cli/options/option.hpp"
#include "geometry/angle.hpp"

#include <functional>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace orograph {

/// Adds options of one heading to a table. All that an option stores into must outlive it.
///
/// Each kind is told its names as help has them ("-j, --jobs N", "--fov DEG", "--crop", or OUTPUT
/// of a positional argument), its help, what is allowed, and its default. Of a number or a choice
/// that isn't std::optional the default is the value it stores into, unless a text says another.
class OptionGroup {
public:
  using Take = std::function<bool(const std::string& text)>;

  explicit OptionGroup(std::vector<Option>& options, std::string_view heading = {})
      : options_(options), heading_(heading) {}

  /// Any value that `take` takes.
  OptionGroup& value(std::string_view names, std::string_view help, std::string_view allowed,
                     std::string_view by_default, Take take);

  /// What `parse` makes of a value, if it makes anything of it.
  template <class Parse, class Into>
  OptionGroup& parsed(std::string_view names, std::string_view help, std::string_view allowed,
                      std::string_view by_default, Parse parse, Into& into) {
    return value(names, help, allowed, by_default, [parse, &into](const std::string& text) {
      const auto parsed = parse(text);
      if (parsed) into = *parsed;
      return static_cast<bool>(parsed);
    });
  }

  /// A text that isn't empty, such as a file's name.
  OptionGroup& name(std::string_view names, std::string_view help, std::string_view allowed,
                    std::string_view by_default, std::string& into);

  /// Any text.
  OptionGroup& text(std::string_view names, std::string_view help, std::string_view by_default,
                    std::string& into);

  /// A switch, which makes `to` of `into`.
  template <class Into>
  OptionGroup& flag(std::string_view names, std::string_view help, Into& into,
                    std::type_identity_t<Into> to) {
    return value(names, help, {}, {}, [&into, to](const std::string&) {
      into = to;
      return true;
    });
  }
  OptionGroup& flag(std::string_view names, std::string_view help, bool& into) {
    return flag(names, help, into, true);
  }

  /// A finite number in the range; of an angle in degrees.
  OptionGroup& number(std::string_view names, std::string_view help, const NumberRange& range,
                      double& into, std::string_view by_default = {});
  OptionGroup& number(std::string_view names, std::string_view help, const NumberRange& range,
                      std::optional<double>& into, std::string_view by_default = {});
  OptionGroup& number(std::string_view names, std::string_view help, const NumberRange& range,
                      Angle& into, std::string_view by_default);
  OptionGroup& number(std::string_view names, std::string_view help, const NumberRange& range,
                      std::optional<Angle>& into, std::string_view by_default = {});
  OptionGroup& number(std::string_view names, std::string_view help, const NumberRange& range,
                      std::function<void(double)> store, std::string_view by_default = {});

  /// A whole number from `low` to `high`; where `high` is the largest there is, it isn't spoken of.
  OptionGroup& whole(std::string_view names, std::string_view help, int low, int high, int& into,
                     std::string_view by_default = {});
  OptionGroup& whole(std::string_view names, std::string_view help, int low, int high,
                     std::optional<int>& into, std::string_view by_default = {});
  OptionGroup& whole(std::string_view names, std::string_view help, int low, int high,
                     std::function<void(int)> store, std::string_view by_default = {});

  /// One word of a few, which make up its placeholder: "surface|profiles".
  template <class Into>
  OptionGroup&
  choice(std::string_view names, std::string_view help,
         std::initializer_list<std::pair<const char*, std::type_identity_t<Into>>> choices,
         Into& into, std::string_view by_default = {}) {
    std::vector<std::string_view> words;
    std::vector<Into> values;
    for (const auto& [word, value] : choices) {
      words.emplace_back(word);
      values.push_back(value);
      if (std::is_scalar_v<Into> && by_default.empty() && into == value) by_default = word;
    }
    return one_of(names, help, std::move(words), by_default,
                  [values, &into](std::size_t i) { into = values[i]; });
  }

  // Of the option that was added last.

  /// A number that it has where none follows it.
  OptionGroup& if_alone(std::string_view value);
  OptionGroup& repeatable();
  /// What may be its value, or stand in it.
  OptionGroup& words(std::vector<std::string> words);
  /// Extensions of the files that it takes.
  OptionGroup& files(std::vector<std::string> extensions);
  /// What parts a value of several parts, where it isn't a comma.
  OptionGroup& between(char separator);

private:
  OptionGroup& one_of(std::string_view names, std::string_view help,
                      std::vector<std::string_view> words, std::string_view by_default,
                      std::function<void(std::size_t)> store);

  std::vector<Option>& options_;
  std::string_view heading_; // a literal
};

} // namespace orograph
