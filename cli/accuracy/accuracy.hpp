// SPDX-License-Identifier: GPL-3.0-or-later
// `orograph accuracy`: what each setting costs in time, and in error on paper.
#pragma once

#include "cli/render_settings.hpp"
#include "measure/accuracy.hpp"

#include <string>
#include <vector>

namespace orograph {

struct AccuracySettings : AccuracySpec {
  RenderSettings render; ///< terrain, view, page
  std::string prefix;    ///< of the files written: .csv, .json, .svg; empty: none
};

/// Throws Error, which names the first row that broke its promise.
void check_promises(const std::vector<AccuracyRow>& rows);

/// Measures all rows, prints the table, writes PREFIX.csv, PREFIX.json and the curve PREFIX.svg.
/// Throws Error where a row's measured error is more than was promised, after all is written.
void accuracy(const AccuracySettings& settings);

} // namespace orograph
