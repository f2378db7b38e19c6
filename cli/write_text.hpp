// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace orograph {

/// Writes a text as a file that appears whole or not at all. Throws Error as `OutputFile` does, and
/// where there is no room.
void write_text(const std::string& text, const std::string& path, bool overwrite);

} // namespace orograph
