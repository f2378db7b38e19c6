// SPDX-License-Identifier: GPL-3.0-or-later
// Options in a file: TOML that people write, or the report of a run.
#pragma once

#include "cli/options/option.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace orograph {

/// A key of a settings file with what it is set to.
struct Setting {
  enum class Kind { value, list, yes_or_no, other };
  std::string key;
  std::size_t line = 0; ///< 0: not known, in a report
  Kind kind = Kind::other;
  /// As on the command line: of `value` one, of `list` all, of `yes_or_no` one for yes and none for
  /// no; of `other` what it is instead: "a table".
  std::vector<std::string> values;
};

/// Adds to `given`, the options of the command line, those of a settings file. What the command
/// line gives stays, and of the file nothing is taken that is in conflict with it. Options of other
/// commands are passed over, so that one file serves all. A path in the file is taken from the
/// file's folder.
/// Throws Error, which names file and line: no such file, over 1 MB (a report: 20 MB), not TOML or
/// JSON; a key that is no option, or one that belongs on the command line; not one value.
void add_settings(const Command& command, const std::string& path, GivenOptions& given);

/// The options that decide what a command draws, by name with their values, in the table's order:
/// those given, and the defaults of others where these are values and not words; to tell the two
/// apart they are handed to `take`. A path is as a settings file in `folder` takes it.
NamedValues options_in_force(const Command& command, const GivenOptions& given,
                             const std::string& folder);

} // namespace orograph
