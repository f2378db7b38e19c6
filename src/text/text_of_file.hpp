// SPDX-License-Identifier: GPL-3.0-or-later
// Text files, whole.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

namespace orograph {

/// What a file should be, for messages.
struct TextKind {
  std::size_t most_bytes = 0;
  const char* noun = "";  ///< "a view"
  const char* right = ""; ///< what to give instead of a file that can't be read
};

/// Throws Error, which begins with the path: no such file, a folder, not readable, larger than
/// `kind.most_bytes`.
std::string text_of_file(const std::string& path, const TextKind& kind);

/// Of any size, as a program wrote it; none where there is no such file. Throws Error where it
/// can't be read, as a folder can't.
std::optional<std::string> whole_file(const std::string& path);

} // namespace orograph
