// SPDX-License-Identifier: GPL-3.0-or-later
// `orograph accuracy`: what each setting costs in time, and in error on paper.
#pragma once

#include "cli/render_settings.hpp"
#include "cli/report/run_report.hpp"
#include "dem/terrain.hpp"
#include "map/meters.hpp"

#include <optional>
#include <string>
#include <vector>

namespace orograph {

struct AccuracySettings {
  RenderSettings render; ///< terrain, view, page; what rows differ in is set row by row
  /// Numbers of profiles; none: as many as the grid has rows.
  std::vector<std::optional<int>> profiles{60, 150, 300, std::nullopt};
  int probes = 20000; ///< points asked of the ray walk, each row
  int repeats = 3;    ///< runs that are timed, each row; the fastest counts
  std::string prefix; ///< of the files written: .csv, .json, .svg; empty: none
};

/// How far lines are from those of the same drawing with all its points.
struct SimplifiedDistance {
  /// Hausdorff distance between strokes, the largest; at least, since the drawing with all its
  /// points is rounded to the page's step as well: that much is taken off.
  double largest_mm = 0;
  std::uint64_t strokes = 0;   ///< compared
  std::uint64_t unmatched = 0; ///< that the drawing with all its points doesn't have
};

enum class Arithmetic { float32, float64, exact };

struct RowSettings {
  Occluder occluder = Occluder::surface;
  std::optional<int> profiles = {}; ///< none: as many as the grid has rows
  double simplify_mm = 0.02;
  bool collapse = true;
  std::optional<int> overview = {};
  std::optional<double> level_error_mm = {}; ///< cells as large as that lets them be
  Arithmetic arithmetic = Arithmetic::float64;
};

/// What the error budget promises of a row; none where it promises nothing.
struct RowPromise {
  std::optional<double> ink_error;       ///< share of the visible length
  std::optional<double> displacement_mm; ///< of ends and, by simplification, of all points
  std::optional<double> simplified_mm;   ///< of points by simplification alone
  std::optional<double> detail_mm = {};  ///< of points by larger cells
};

struct AccuracyRow {
  std::string group; ///< what is varied: "profiles", "simplify", "overview", "collapse", …
  RowSettings settings;
  RowPromise promise;

  std::size_t profile_count = 0;
  StageSeconds seconds; ///< facing to layout; total is their sum
  Counts counts;
  InkSample profiles, lines; ///< ink of the profiles, and of all other lines
  EndSample ends;
  std::optional<SimplifiedDistance> simplified; ///< none where nothing was laid out
  /// The longest stretch of a profile that is visible here and hidden by exact arithmetic, or the
  /// other way round; where arithmetic is varied, but for exact arithmetic itself.
  std::optional<double> arithmetic_mm;
  /// By level of detail, from the file's heights; of overviews and of larger cells.
  std::optional<double> detail_mm;

  /// The largest that was found, by all causes together.
  double displacement_mm() const {
    return ends.largest_mm + (simplified ? simplified->largest_mm : 0) + detail_mm.value_or(0);
  }
};

/// "surface, 300 profiles, simplify 0.1 mm": settings that differ from the defaults are told.
std::string name_of(const AccuracyRow& row);

/// The settings to measure: each number of profiles with either occluder; then, with one of the
/// numbers, simplification, overviews (those that the file has), the error of larger cells,
/// collapse and arithmetic varied one at a time.
std::vector<AccuracyRow> accuracy_rows(const AccuracySettings& settings);

/// The row's measures into it. REQUIRES that `whole` was read from the file at full heights.
/// Throws Error as `read_raster` and `placed_view` do.
void measure_row(AccuracyRow& row, const AccuracySettings& settings, const TerrainData& whole);

/// What a row measured beyond its promise, a sentence; empty where the promise was kept.
std::string broken_promise(const AccuracyRow& row);

/// Throws Error, which names the first row that broke its promise.
void check_promises(const std::vector<AccuracyRow>& rows);

/// Measures all rows, prints the table, writes PREFIX.csv, PREFIX.json and the curve PREFIX.svg.
/// Throws Error where a row's measured error is more than was promised, after all is written.
void accuracy(const AccuracySettings& settings);

} // namespace orograph
