// SPDX-License-Identifier: GPL-3.0-or-later
// The files that the cases of bad_input.txt read.
#pragma once

#include "tests/cli/made_files.hpp"

namespace orograph {

/// Makes all files that the head of bad_input.txt names, and nothing else.
void make_bad_inputs(const MadeFolder& folder);

} // namespace orograph
