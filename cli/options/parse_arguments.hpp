// SPDX-License-Identifier: GPL-3.0-or-later
// A command line against the table of a command's options; the only place that knows CLI11.
#pragma once

#include "cli/options/option.hpp"

#include <string>
#include <vector>

namespace orograph {

/// Hands every value of the command line (without the program's and the command's name) to its
/// option's `take`, in the table's order, and returns which options were given; those of a settings
/// file that it names too (`add_settings`). Where help is among them nothing else is looked at.
/// Throws UsageError: an option that the table doesn't have (with the nearest that it has), a
/// missing, superfluous, repeated or unsuitable value, two options in conflict. Throws Error for
/// the like in a settings file.
GivenOptions parse_arguments(const Command& command, const std::vector<std::string>& arguments);

/// The same of options by name, without dashes, and positional arguments by theirs, as a program
/// gives them.
GivenOptions take_named(const Command& command, const NamedValues& named);

} // namespace orograph
