// SPDX-License-Identifier: GPL-3.0-or-later
// Which rows are measured, what they are called and what they promise.
#include "measure/accuracy.hpp"

#include "dem/read/read_raster.hpp"
#include "geometry/error.hpp"

#include <fmt/format.h>

namespace orograph {
namespace {

// As many as the file has, told by which of them can be read. The coarsest may be too small to be a
// terrain.
int overview_count(const MeasuredTerrain& terrain) {
  ReadOptions options = terrain.reading;
  for (int level = 0;; ++level) {
    options.overview = level;
    try {
      read_rasters(terrain.inputs, options);
    } catch (const Error&) {
      return level;
    }
  }
}

} // namespace

std::string name_of(const AccuracyRow& row) {
  const RowSettings& s = row.settings;
  std::string name =
      fmt::format("{}, {} profiles", s.occluder == Occluder::surface ? "surface" : "profiles",
                  row.profile_count);
  if (s.simplify_mm != RowSettings{}.simplify_mm)
    name += fmt::format(", simplify {} mm", s.simplify_mm);
  if (s.overview) name += fmt::format(", overview {}", *s.overview);
  if (s.level_error_mm) name += fmt::format(", level error {} mm", *s.level_error_mm);
  if (!s.collapse) name += ", no collapse";
  if (s.arithmetic == Arithmetic::float32) name += ", float";
  if (s.arithmetic == Arithmetic::float64 && row.group == "arithmetic") name += ", double";
  if (s.arithmetic == Arithmetic::exact) name += ", exact";
  return name;
}

std::vector<AccuracyRow> accuracy_rows(const AccuracySpec& spec, const MeasuredTerrain& terrain) {
  std::vector<AccuracyRow> rows;
  const auto add = [&](const std::string& group, const RowSettings& row) {
    rows.emplace_back();
    rows.back().group = group;
    rows.back().settings = row;
  };
  for (const Occluder occluder : {Occluder::surface, Occluder::profiles})
    for (const auto& number : spec.profiles)
      add("profiles", {.occluder = occluder, .profiles = number});

  // All else is varied at one number of profiles, the middle one.
  const auto number = spec.profiles[spec.profiles.size() / 2];
  for (const double mm : {0.0, 0.1}) add("simplify", {.profiles = number, .simplify_mm = mm});
  const int overviews = overview_count(terrain);
  for (int level = 0; level < overviews; ++level)
    add("overview", {.profiles = number, .overview = level});
  for (const double mm : {0.05, 0.2, 0.8})
    add("level error", {.profiles = number, .level_error_mm = mm});
  // The surface's horizon rises by silhouettes alone; these two are about profiles that hide.
  add("collapse", {.occluder = Occluder::profiles, .profiles = number, .collapse = false});
  for (const Arithmetic arithmetic : {Arithmetic::float32, Arithmetic::float64, Arithmetic::exact})
    add("arithmetic",
        {.occluder = Occluder::profiles, .profiles = number, .arithmetic = arithmetic});
  return rows;
}

std::string broken_promise(const AccuracyRow& row) {
  const RowPromise& promise = row.promise;
  const InkSample ink = row.profiles + row.lines;
  if (promise.ink_error && ink.error() > *promise.ink_error)
    return fmt::format("its ink error is {:.3g} %, promised {:.3g} %", 100 * ink.error(),
                       100 * *promise.ink_error);
  if (promise.displacement_mm && row.displacement_mm() > *promise.displacement_mm)
    return fmt::format("its displacement is {:.3g} mm, promised {:.3g} mm", row.displacement_mm(),
                       *promise.displacement_mm);
  if (promise.detail_mm && row.detail_mm && *row.detail_mm > *promise.detail_mm)
    return fmt::format("its larger cells moved a point by {:.3g} mm, promised {:.3g} mm",
                       *row.detail_mm, *promise.detail_mm);
  if (promise.simplified_mm && row.simplified &&
      row.simplified->largest_mm > *promise.simplified_mm)
    return fmt::format("its simplification moved a point by {:.3g} mm, promised {:.3g} mm",
                       row.simplified->largest_mm, *promise.simplified_mm);
  return "";
}

} // namespace orograph
