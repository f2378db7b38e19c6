// SPDX-License-Identifier: GPL-3.0-or-later
// The rows of `orograph fragmentation` as text, tables to read, CSV and JSON, with their growth;
// and as plots.
#pragma once

#include "cli/fragmentation/fragmentation.hpp"

#include <string>
#include <vector>

namespace orograph {

/// Aligned columns, a heading of two lines; "-" where nothing was run.
std::string fragmentation_table(const std::vector<FragmentationRow>& rows);
/// The exponents of growth with the number of profiles, a line for each terrain and view with more
/// than one number of them; empty where there is none.
std::string growth_table(const std::vector<FragmentationRow>& rows);

/// A line of names and a line for each row. Empty where nothing was run.
std::string fragmentation_csv(const std::vector<FragmentationRow>& rows);
/// A line for each profile of each row: the horizon's pieces behind it.
std::string series_csv(const std::vector<FragmentationRow>& rows);

/// Rows and exponents, `"schema": 1`, with the program's version and what was measured.
std::string fragmentation_json(const std::vector<FragmentationRow>& rows,
                               const std::string& terrain);

/// Writes plots as one SVG to `path`, an existing file or a new one: pieces over profiles with
/// either occluder, pieces after each profile, seconds, the worst cases. Throws Error where gnuplot
/// is missing or fails.
void plot_fragmentation(const std::vector<FragmentationRow>& rows, const std::string& title,
                        const std::string& path);

/// What gnuplot is told; for `plot_fragmentation` and its test.
std::string fragmentation_plot_script(const std::vector<FragmentationRow>& rows,
                                      const std::string& title, const std::string& path);

} // namespace orograph
