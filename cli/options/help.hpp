// SPDX-License-Identifier: GPL-3.0-or-later
// The tables of options as text: `--help` and the man page.
#pragma once

#include "cli/options/option.hpp"

#include <string>
#include <vector>

namespace orograph {

enum class HelpLength { daily, all };

/// What `orograph COMMAND --help` or `--help-all` prints, in lines of at most 80 characters.
std::string command_help(const Command& command, HelpLength length);
/// What `orograph --help` prints.
std::string program_help(const std::vector<Command>& commands);
/// orograph(1) in troff's man macros. The same bytes for the same tables and version.
std::string man_page(const std::vector<Command>& commands);

/// "orograph 0.2.0 (commit 1a2b3c4)".
std::string version_line();

} // namespace orograph
