// SPDX-License-Identifier: GPL-3.0-or-later
// Small texts from files and to files.
#pragma once

#include <optional>
#include <string>

namespace orograph {

/// None where there is no such file. Throws Error where it can't be read, as a folder can't.
std::optional<std::string> whole_file(const std::string& path);

/// Writes the text whole or not at all. Throws Error where it can't be written, or exists and
/// `overwrite` is off.
void write_text(const std::string& text, const std::string& path, bool overwrite);

} // namespace orograph
