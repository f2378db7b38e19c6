// SPDX-License-Identifier: GPL-3.0-or-later
// `orograph fragmentation`: how the horizon fragments, and what collapse keeps of it.
#pragma once

#include "cli/fragmentation/fragmentation_row.hpp"
#include "cli/render_settings.hpp"
#include "dem/terrain.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace orograph {

struct FragmentationSettings {
  RenderSettings render; ///< terrain; what rows differ in is set row by row
  std::vector<int> profiles{15, 30, 60, 125, 250, 500, 1000, 2000};
  std::vector<double> elevations_deg{2, 5, 10, 25, 45, 70};
  /// Along the rows of a grid, along its columns, and oddly between.
  std::vector<double> azimuths_deg{90, 180, 217};
  int exact_segments = 100000;          ///< rows with more occluders aren't run in exact arithmetic
  int fragmented_segments = 1000000;    ///< and not without collapse
  int worst_case = 1000;                ///< the largest size of the worst cases; 0: none
  int repeats = 1;                      ///< runs that are timed, each row; the fastest counts
  std::string prefix = "fragmentation"; ///< of the files written
};

/// The rows to measure on a terrain: each number of profiles in each view, with either occluder.
std::vector<FragmentationRow> fragmentation_rows(const FragmentationSettings& settings);

/// The row's measures into it. Throws Error as `placed_view` does.
void measure_row(FragmentationRow& row, const FragmentationSettings& settings,
                 const TerrainData& terrain);

/// Measures all rows and the worst cases, prints the tables, writes PREFIX.csv, PREFIX-series.csv,
/// PREFIX.json and the plots, PREFIX.svg. Throws Error where collapse doesn't keep a horizon at its
/// least size, after all is written.
void fragmentation(const FragmentationSettings& settings);

} // namespace orograph
