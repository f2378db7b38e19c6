// SPDX-License-Identifier: GPL-3.0-or-later
// Small files into memory.
#pragma once

#include <optional>
#include <string>

namespace orograph {

/// None where there is no such file. Throws Error where it can't be read, as a folder can't.
std::optional<std::string> whole_file(const std::string& path);

} // namespace orograph
