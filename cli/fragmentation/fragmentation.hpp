// SPDX-License-Identifier: GPL-3.0-or-later
// `orograph fragmentation`: how the horizon fragments, and what collapse keeps of it.
#pragma once

#include "cli/render_settings.hpp"
#include "measure/fragmentation.hpp"

#include <string>
#include <vector>

namespace orograph {

struct FragmentationSettings : FragmentationSpec {
  RenderSettings render; ///< terrain; what rows differ in is set row by row
  std::string prefix;    ///< of the files written; empty: none
};

/// Throws Error, which names the first row that broke its promise.
void check_promises(const std::vector<FragmentationRow>& rows);

/// Measures all rows and the worst cases, prints the tables, writes PREFIX.csv, PREFIX-series.csv,
/// PREFIX.json and the plots, PREFIX.svg. Throws Error where collapse doesn't keep a horizon at its
/// least size, after all is written.
void fragmentation(const FragmentationSettings& settings);

} // namespace orograph
