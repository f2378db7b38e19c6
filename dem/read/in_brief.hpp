// SPDX-License-Identifier: GPL-3.0-or-later
// Several files in few words.
#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string>
#include <vector>

namespace orograph {

/// "a.tif", or "a.tif and 3 more". REQUIRES at least one.
inline std::string in_brief(const std::vector<std::string>& paths) {
  return paths.size() == 1 ? paths.front()
                           : fmt::format("{} and {} more", paths.front(), paths.size() - 1);
}

/// As a command line has them; "FILES" where there are more than a line holds.
inline std::string in_command(const std::vector<std::string>& paths) {
  return paths.size() > 4 ? "FILES" : fmt::format("{}", fmt::join(paths, " "));
}

} // namespace orograph
