// SPDX-License-Identifier: GPL-3.0-or-later
// The curve of speed against error.
#pragma once

#include "cli/accuracy/accuracy_row.hpp"

#include <string>
#include <vector>

namespace orograph {

/// Writes it as SVG to `path`, an existing file or a new one. Throws Error where gnuplot is missing
/// or fails.
void plot_accuracy(const std::vector<AccuracyRow>& rows, const std::string& title,
                   const std::string& path);

/// What gnuplot is told; for `plot_accuracy` and its test.
std::string accuracy_plot_script(const std::vector<AccuracyRow>& rows, const std::string& title,
                                 const std::string& path);

} // namespace orograph
