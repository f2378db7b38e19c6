// SPDX-License-Identifier: GPL-3.0-or-later
// The tables of options as text: `--help` and the man page, for programs that call a command, and
// for shells.
#pragma once

#include "cli/options/option.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace orograph {

enum class HelpLength { daily, all };

/// What `orograph COMMAND --help` or `--help-all` prints, in lines of at most 80 characters.
std::string command_help(const Command& command, HelpLength length);
/// What `orograph --help` prints.
std::string program_help(const std::vector<Command>& commands);
/// orograph(1) in troff's man macros. The same bytes for the same tables and version.
std::string man_page(const std::vector<Command>& commands);

/// JSON for programs that call it, an object with the keys that `gdal --json-usage` has for the
/// same, as far as there are such: `name`, `description`, `examples`, and `input_arguments`, each
/// with `name`, `type` (string, boolean, integer or real), `description`, and where they tell
/// something `metavar`, `allowed`, `default` (a value as it may be given) or `default_text`,
/// `min_value` and `max_value` with `…_is_included`, `unit`, `choices` (all that it may be),
/// `words` (some that it may be), `list` (choices with commas between), `repeatable`, `extensions`,
/// `between`, `group`, `short`, and of positional arguments `positional` and `required`.
std::string usage_json(const Command& command);

/// A script for "bash", "zsh" or "fish" that completes commands, options, and of options' values
/// the words that there are, alone or in a list, and files by their extensions. It calls no
/// program. Throws UsageError for another shell.
std::string completion(const std::vector<Command>& commands, std::string_view shell);

/// "orograph 0.2.0 (commit 1a2b3c4)".
std::string version_line();

} // namespace orograph
