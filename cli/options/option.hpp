// SPDX-License-Identifier: GPL-3.0-or-later
// One option, and one command, as data: what parsing, `--help` and the man page are made from.
// option_group.hpp makes them.
#pragma once

#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace orograph {

struct NumberRange {
  std::string_view unit = {}; ///< of a literal; empty for a plain number
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool low_excluded = false, high_excluded = false;

  bool holds(double x) const {
    return (low_excluded ? x > low : x >= low) && (high_excluded ? x < high : x <= high);
  }
  /// "degrees, above 0 and below 180".
  std::string describe() const;
};

struct Option {
  std::string group;       ///< heading in the help; empty for positional arguments
  std::string name;        ///< "--fov", or "INPUT" for a positional argument (always required)
  char letter = 0;         ///< of the short form; 0 for none
  std::string value;       ///< placeholder, "DEG"; empty for a switch
  std::string if_alone;    ///< a number that it has where none follows it; empty: one has to
  std::string help;        ///< a sentence without a full stop
  std::string allowed;     ///< which values are right, with their unit; also used in errors
  std::string by_default;  ///< empty where the help says all
  bool repeatable = false; ///< of positional arguments one at most may be
  // What programs that complete a line, or make one, want to know beside.
  std::vector<std::string> words;      ///< that may be its value, or stand in it
  std::vector<std::string> extensions; ///< of the files that it takes; empty: any
  char between = ',';                  ///< what parts a value of several parts
  std::optional<NumberRange> range;    ///< where its value is a number
  bool is_whole = false;               ///< that number
  /// Stores one value; false where it isn't one of those allowed. Switches get an empty text.
  std::function<bool(const std::string& text)> take;

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

/// Two options that exclude each other, and what to do instead; literals.
struct Conflict {
  std::string_view one, other, right;
};

struct Example {
  std::string_view command, meaning; ///< literals
};

struct Command {
  std::string name;
  std::string summary; ///< a line
  std::vector<Option> options;
  std::vector<Conflict> conflicts;
  std::vector<Example> examples;
  /// Names of the options that people use every day, which `--help` shows, with blanks between;
  /// empty: it shows all.
  std::string_view daily = {};

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
using GivenOptions = std::map<std::string, GivenOption, std::less<>>;

/// Whether either help is given.
inline bool asks_for_help(const GivenOptions& given) {
  return given.contains("--help") || given.contains("--help-all");
}

/// Options by name without dashes, with their values; a switch has none.
using NamedValues = std::vector<std::pair<std::string, std::vector<std::string>>>;

/// Whether the name is one of these, which have a blank between.
bool is_among(std::string_view names, std::string_view name);

/// Whether the command line itself gives the option. Where it has no meaning that is an error; from
/// a settings file, which serves many drawings, it is passed over.
bool insists_on(const GivenOptions& given, std::string_view option);

/// Throws UsageError, "OPTION has no meaning WHERE", for the first of these that the command line
/// gives. There is a blank between several.
void refuse(const GivenOptions& given, std::string_view options, std::string_view where,
            std::string_view right);

} // namespace orograph
