// SPDX-License-Identifier: GPL-3.0-or-later
// Runs of the command in which one call after another fails.
#pragma once

#include "tests/cli/made_files.hpp"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace orograph {

struct WalkedCommand {
  std::string name;
  std::vector<std::string> arguments;
  std::vector<std::pair<std::string, std::string>> older = {}; ///< files that are there already
  /// What it does one after another may be done in part: then each file is right or whole.
  bool in_parts = false;
  std::vector<std::vector<std::string>> before = {}; ///< commands that make more of its inputs
};

/// Every command, render to every format, and every kind of input; they read the files of
/// `make_inputs`.
const std::vector<WalkedCommand>& walked_commands();
void make_inputs(const MadeFolder& folder);

struct Walk {
  std::size_t faults = 0;  ///< calls that were made to fail
  std::size_t refused = 0; ///< runs that told of it, with exit code 1
  /// Runs that another library ended, by abort() or worse where its own call had no memory.
  std::size_t ended_by_others = 0;
  std::vector<std::string> wrong; ///< "svg memory:12: what"
};

/// Runs the command so often that of each of these kinds of calls up to `each` fail in turn, spread
/// over all that there are: what comes out must be what comes out without a fault, or one line,
/// exit code 1, and nothing but what was there before.
Walk walk(const WalkedCommand& command, const std::vector<std::string>& kinds, std::size_t each);

/// Of fail_call.cpp.
const std::vector<std::string>& fault_kinds();

} // namespace orograph
