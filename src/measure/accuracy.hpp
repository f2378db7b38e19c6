// SPDX-License-Identifier: GPL-3.0-or-later
// What each way of drawing a terrain costs in time, and in error on paper: rows that differ in one
// setting each, measured against the ray walk, exact arithmetic and the drawing with all its
// points.
#pragma once

#include "dem/read/read_options.hpp"
#include "dem/terrain.hpp"
#include "map/map_facts.hpp"
#include "measure/meters.hpp"
#include "placing/map_spec.hpp"

#include <optional>
#include <string>
#include <vector>

namespace orograph {

/// What is varied, and how thoroughly it is measured.
struct AccuracySpec {
  /// Numbers of profiles; none: as many as the grid has rows.
  std::vector<std::optional<int>> profiles{60, 150, 300, std::nullopt};
  int probes = 20000; ///< points asked of the ray walk, each row
  int repeats = 3;    ///< runs that are timed, each row; the fastest counts
};

/// The terrain at full heights, and the files that its overviews are read from.
struct MeasuredTerrain {
  std::vector<std::string> inputs;
  ReadOptions reading;
  TerrainData whole;
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
std::vector<AccuracyRow> accuracy_rows(const AccuracySpec& spec, const MeasuredTerrain& terrain);

/// The row's measures into it, of the view and page of `map`; what rows differ in is the row's own.
/// Throws Error as `read_raster`, `placed_view` and `check_not_empty` do.
void measure_row(AccuracyRow& row, const AccuracySpec& spec, const MeasuredTerrain& terrain,
                 const MapSpec& map);

/// What a row measured beyond its promise, a sentence; empty where the promise was kept.
std::string broken_promise(const AccuracyRow& row);

} // namespace orograph
