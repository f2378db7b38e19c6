// SPDX-License-Identifier: GPL-3.0-or-later
// The rows of `orograph accuracy` as text, a table to read, CSV and JSON, and as the curve of speed
// against error.
#pragma once

#include "cli/accuracy/accuracy.hpp"

#include <string>
#include <vector>

namespace orograph {

/// Aligned columns, a heading of two lines; milliseconds, percent, mm.
std::string accuracy_table(const std::vector<AccuracyRow>& rows);

/// A line of names and a line for each row; seconds, shares, mm. Empty where nothing is known.
std::string accuracy_csv(const std::vector<AccuracyRow>& rows);

/// The same, `"schema": 1`, with the program's version and what was measured.
std::string accuracy_json(const std::vector<AccuracyRow>& rows, const std::string& terrain);

/// Writes it as SVG to `path`, an existing file or a new one. Throws Error where gnuplot is missing
/// or fails.
void plot_accuracy(const std::vector<AccuracyRow>& rows, const std::string& title,
                   const std::string& path);

/// What gnuplot is told; for `plot_accuracy` and its test.
std::string accuracy_plot_script(const std::vector<AccuracyRow>& rows, const std::string& title,
                                 const std::string& path);

} // namespace orograph
