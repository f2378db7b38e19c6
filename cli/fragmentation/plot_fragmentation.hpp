// SPDX-License-Identifier: GPL-3.0-or-later
// The plots of a fragmentation study.
#pragma once

#include "cli/fragmentation/fragmentation_row.hpp"

#include <string>
#include <vector>

namespace orograph {

/// Writes them as one SVG to `path`, an existing file or a new one: pieces over profiles with
/// either occluder, pieces after each profile, seconds, the worst cases. Throws Error where gnuplot
/// is missing or fails.
void plot_fragmentation(const std::vector<FragmentationRow>& rows, const std::string& title,
                        const std::string& path);

/// What gnuplot is told; for `plot_fragmentation` and its test.
std::string fragmentation_plot_script(const std::vector<FragmentationRow>& rows,
                                      const std::string& title, const std::string& path);

} // namespace orograph
