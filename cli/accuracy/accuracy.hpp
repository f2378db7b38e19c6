// SPDX-License-Identifier: GPL-3.0-or-later
// `orograph accuracy`: what each setting costs in time, and in error on paper.
#pragma once

#include "cli/accuracy/accuracy_row.hpp"
#include "cli/render_settings.hpp"
#include "dem/terrain.hpp"

#include <optional>
#include <string>
#include <vector>

namespace orograph {

struct AccuracySettings {
  RenderSettings render; ///< terrain, view, page; what rows differ in is set row by row
  /// Numbers of profiles; none: as many as the grid has rows.
  std::vector<std::optional<int>> profiles{60, 150, 300, std::nullopt};
  int probes = 20000;              ///< points asked of the ray walk, each row
  int repeats = 3;                 ///< runs that are timed, each row; the fastest counts
  std::string prefix = "accuracy"; ///< of the files written: .csv, .json, .svg
};

/// The settings to measure: each number of profiles with either occluder; then, with one of the
/// numbers, simplification, overviews (those that the file has), collapse and arithmetic varied one
/// at a time.
std::vector<AccuracyRow> accuracy_rows(const AccuracySettings& settings);

/// The row's measures into it. REQUIRES that `full` was read from the file at full heights.
/// Throws Error as `read_raster` and `placed_view` do.
void measure_row(AccuracyRow& row, const AccuracySettings& settings, const TerrainData& full);

/// Measures all rows, prints the table, writes PREFIX.csv, PREFIX.json and the curve PREFIX.svg.
/// Throws Error where a row's measured error is more than was promised, after all is written.
void accuracy(const AccuracySettings& settings);

} // namespace orograph
