// SPDX-License-Identifier: GPL-3.0-or-later
// One option, and one command, as data: what parsing, `--help` and the man page are made from.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace orograph {

/// Every member has a value of its own, so that a table names only what matters.
struct Option {
  std::string group = {};      ///< heading in the help; empty for positional arguments
  std::string name = {};       ///< "--fov", or "INPUT" for a positional argument (always required)
  char letter = 0;             ///< of the short form; 0 for none
  std::string value = {};      ///< placeholder, "DEG"; empty for a switch
  std::string help = {};       ///< a sentence without a full stop
  std::string allowed = {};    ///< which values are right, with their unit; also used in errors
  std::string by_default = {}; ///< empty where the help says all
  bool repeatable = false;     ///< of positional arguments one at most may be
  /// Stores one value; false where it isn't one of those allowed. Switches get an empty text.
  std::function<bool(const std::string& text)> take = {};

  bool is_positional() const { return !name.starts_with('-'); }
  bool is_switch() const { return value.empty() && !is_positional(); }
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
};

/// The options that a command line gives, with their values as given: one empty value for a switch.
using GivenOptions = std::map<std::string, std::vector<std::string>>;

} // namespace orograph
