// SPDX-License-Identifier: GPL-3.0-or-later
// Texts to files.
#pragma once

#include <string>

namespace orograph {

/// Writes the text whole or not at all. Throws Error where it can't be written, or exists and
/// `overwrite` is off.
void write_text(const std::string& text, const std::string& path, bool overwrite);

} // namespace orograph
