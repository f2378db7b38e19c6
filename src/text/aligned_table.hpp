// SPDX-License-Identifier: GPL-3.0-or-later
// A table to be read on a terminal.
#pragma once

#include <string>
#include <vector>

namespace orograph {

/// Columns as wide as their widest cell, counted in characters; the first to the left, the others
/// to the right. REQUIRES that all rows have as many cells.
std::string aligned_table(const std::vector<std::vector<std::string>>& rows);

} // namespace orograph
