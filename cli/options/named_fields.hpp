// SPDX-License-Identifier: GPL-3.0-or-later
// What the library's messages call a field, the command calls an option.
#pragma once

#include <string>

namespace orograph {

/// The message with each `field` of the library's face, in backquotes, put as the option that sets
/// it: "`look_at_map` X,Y" becomes "--look-at X,Y". Other words in backquotes stay.
std::string with_options(std::string message);

} // namespace orograph
