// SPDX-License-Identifier: GPL-3.0-or-later
// The tables of options as scripts by which shells complete a command line.
#pragma once

#include "cli/options/option.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace orograph {

/// A script for "bash", "zsh" or "fish" that completes commands, options, and of options' values
/// the words that there are, alone or in a list, and files by their extensions. It calls no
/// program. Throws UsageError for another shell.
std::string completion(const std::vector<Command>& commands, std::string_view shell);

} // namespace orograph
