// SPDX-License-Identifier: GPL-3.0-or-later
// Several files in few words.
#pragma once

#include <fmt/format.h>

#include <string>
#include <vector>

namespace orograph {

/// "a.tif", or "a.tif and 3 more". REQUIRES at least one.
inline std::string in_brief(const std::vector<std::string>& paths) {
  return paths.size() == 1 ? paths.front()
                           : fmt::format("{} and {} more", paths.front(), paths.size() - 1);
}

} // namespace orograph
