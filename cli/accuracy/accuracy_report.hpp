// SPDX-License-Identifier: GPL-3.0-or-later
// The rows of `orograph accuracy` as text: a table to read, CSV, JSON.
#pragma once

#include "cli/accuracy/accuracy_row.hpp"

#include <string>
#include <vector>

namespace orograph {

/// Aligned columns, a heading of two lines; milliseconds, percent, mm.
std::string accuracy_table(const std::vector<AccuracyRow>& rows);

/// A line of names and a line for each row; seconds, shares, mm. Empty where nothing is known.
std::string accuracy_csv(const std::vector<AccuracyRow>& rows);

/// The same, `"schema": 1`, with the program's version and what was measured.
std::string accuracy_json(const std::vector<AccuracyRow>& rows, const std::string& terrain);

} // namespace orograph
