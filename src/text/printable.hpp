// SPDX-License-Identifier: GPL-3.0-or-later
// Text from files, names and options, as a terminal may get it.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace orograph {

/// On one line: every control character, line separator and byte that isn't UTF-8 is a '?'.
std::string printable(std::string_view text);

/// The text, where it has at most so many bytes; else its beginning and its end with " … " between,
/// no character cut. REQUIRES most_bytes >= 100.
std::string shortened(std::string_view text, std::size_t most_bytes);

} // namespace orograph
