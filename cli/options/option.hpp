// SPDX-License-Identifier: GPL-3.0-or-later
// One option, and one command, as data: what parsing, `--help` and the man page are made from.
// Kinds of options: each gives an `Option` its `take`, and the words of `allowed` that say the
// same.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <optional>
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

/// Every member has a value of its own, so that a table names only what matters.
struct Option {
  std::string group = {};      ///< heading in the help; empty for positional arguments
  std::string name = {};       ///< "--fov", or "INPUT" for a positional argument (always required)
  char letter = 0;             ///< of the short form; 0 for none
  std::string value = {};      ///< placeholder, "DEG"; empty for a switch
  std::string if_alone = {};   ///< a number that it has where none follows it; empty: one has to
  std::string help = {};       ///< a sentence without a full stop
  std::string allowed = {};    ///< which values are right, with their unit; also used in errors
  std::string by_default = {}; ///< empty where the help says all
  bool repeatable = false;     ///< of positional arguments one at most may be
  // What programs that complete a line, or make one, want to know beside.
  std::vector<std::string> words = {};      ///< that may be its value, or stand in it
  std::vector<std::string> extensions = {}; ///< of the files that it takes; empty: any
  char between = ',';                       ///< what parts a value of several parts
  std::optional<NumberRange> range = {};    ///< where its value is a number
  bool is_whole = false;                    ///< that number
  /// Stores one value; false where it isn't one of those allowed. Switches get an empty text.
  std::function<bool(const std::string& text)> take = {};

  bool is_positional() const { return !name.starts_with('-'); }
  bool is_switch() const { return value.empty() && !is_positional(); }
  /// `words`, and those that its placeholder names: "cavalier" of "cavalier|cabinet|L,ALPHA".
  std::vector<std::string> words_to_choose() const;
  /// Whether its value is one of these words, and nothing else.
  bool is_choice() const;
  /// Whether its value is a list of them.
  bool is_list_of_words() const { return value == "LIST" && !words.empty(); }
  /// Whether such a value is the name of a file that is read.
  bool is_path(const std::string& given) const {
    return value == "FILE" || (value == "NAME|FILE.toml" && given.ends_with(".toml"));
  }
};

/// Two options that exclude each other, and what to do instead.
struct Conflict {
  std::string one, other, right;
};

struct Example {
  std::string command, meaning;
};

struct Command {
  std::string name;
  std::string summary; ///< a line
  std::vector<Option> options;
  std::vector<Conflict> conflicts;
  std::vector<Example> examples;
  /// Names of the options that people use every day, which `--help` shows; empty: it shows all.
  std::vector<std::string> daily = {};

  /// The option that shows all of them.
  const char* full_help() const { return daily.empty() ? "--help" : "--help-all"; }
};

/// An option that is given, with its values as given: one empty value for a switch.
struct GivenOption {
  std::vector<std::string> values;
  std::string place =
      {}; ///< "a.toml, line 3" of a settings file that gives it; empty: the command line
};
/// By name.
using GivenOptions = std::map<std::string, GivenOption>;

/// Whether either help is given.
inline bool asks_for_help(const GivenOptions& given) {
  return given.contains("--help") || given.contains("--help-all");
}

/// Options by name without dashes, with their values; a switch has none.
using NamedValues = std::vector<std::pair<std::string, std::vector<std::string>>>;

/// Whether the command line itself gives the option. Where it has no meaning that is an error; from
/// a settings file, which serves many drawings, it is passed over.
bool insists_on(const GivenOptions& given, const std::string& option);

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

// What every command takes, or every one that draws.

Option help_option();
Option full_help_option();
Option quiet_option(bool& quiet);
Option jobs_option(int& jobs);
/// Its default is set as well: half of what is free.
Option memory_option(std::optional<std::uint64_t>& bytes);

/// With `--help` and `--settings`.
void add_general_options(std::vector<Option>& options, std::string& settings_file, bool& quiet,
                         std::optional<bool>& progress);

/// What of these is about messages, and `--help`.
void add_message_options(std::vector<Option>& options, bool& quiet, std::optional<bool>& progress);

} // namespace orograph
