// SPDX-License-Identifier: GPL-3.0-or-later
// One row of `orograph accuracy`: settings, what was promised, what was measured.
#pragma once

#include "cli/accuracy/end_meter.hpp"
#include "cli/accuracy/ink_meter.hpp"
#include "cli/accuracy/simplified_distance.hpp"
#include "cli/render_settings.hpp"
#include "cli/report/run_report.hpp"

#include <optional>
#include <string>
#include <vector>

namespace orograph {

enum class Arithmetic { float32, float64, exact };

struct RowSettings {
  Occluder occluder = Occluder::surface;
  std::optional<int> profiles = {}; ///< none: as many as the grid has rows
  double simplify_mm = 0.02;
  bool collapse = true;
  std::optional<int> overview = {};
  Arithmetic arithmetic = Arithmetic::float64;
};

/// What the error budget promises of a row; none where it promises nothing.
struct RowPromise {
  std::optional<double> ink_error;       ///< share of the visible length
  std::optional<double> displacement_mm; ///< of ends and, by simplification, of all points
  std::optional<double> simplified_mm;   ///< of points by simplification alone
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
  std::optional<double> detail_mm; ///< by level of detail, from full heights; overviews only

  /// The largest that was found, by all causes together.
  double displacement_mm() const {
    return ends.largest_mm + (simplified ? simplified->largest_mm : 0) + detail_mm.value_or(0);
  }
};

/// "surface, 300 profiles, simplify 0.1 mm": settings that differ from the defaults are told.
std::string name_of(const AccuracyRow& row);

/// What a row measured beyond its promise, a sentence; empty where the promise was kept.
std::string broken_promise(const AccuracyRow& row);

/// Throws Error, which names the first row that broke its promise.
void check_promises(const std::vector<AccuracyRow>& rows);

} // namespace orograph
