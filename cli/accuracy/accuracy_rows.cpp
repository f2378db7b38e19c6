// SPDX-License-Identifier: GPL-3.0-or-later
// Which settings `orograph accuracy` measures.
#include "cli/accuracy/accuracy.hpp"
#include "dem/read/read_raster.hpp"
#include "geometry/error.hpp"

namespace orograph {
namespace {

// As many as the file has, told by which of them can be read. The coarsest may be too small to be a
// terrain.
int overview_count(const RenderSettings& settings) {
  ReadOptions options = settings.reading;
  for (int level = 0;; ++level) {
    options.overview = level;
    try {
      read_rasters(settings.inputs, options);
    } catch (const Error&) {
      return level;
    }
  }
}

} // namespace

std::vector<AccuracyRow> accuracy_rows(const AccuracySettings& settings) {
  std::vector<AccuracyRow> rows;
  const auto add = [&](const std::string& group, const RowSettings& row) {
    rows.emplace_back();
    rows.back().group = group;
    rows.back().settings = row;
  };
  for (const Occluder occluder : {Occluder::surface, Occluder::profiles})
    for (const auto& number : settings.profiles)
      add("profiles", {.occluder = occluder, .profiles = number});

  // All else is varied at one number of profiles, the middle one.
  const auto number = settings.profiles[settings.profiles.size() / 2];
  for (const double mm : {0.0, 0.1}) add("simplify", {.profiles = number, .simplify_mm = mm});
  const int overviews = overview_count(settings.render);
  for (int level = 0; level < overviews; ++level)
    add("overview", {.profiles = number, .overview = level});
  // The surface's horizon rises by silhouettes alone; these two are about profiles that hide.
  add("collapse", {.occluder = Occluder::profiles, .profiles = number, .collapse = false});
  for (const Arithmetic arithmetic : {Arithmetic::float32, Arithmetic::float64, Arithmetic::exact})
    add("arithmetic",
        {.occluder = Occluder::profiles, .profiles = number, .arithmetic = arithmetic});
  return rows;
}

} // namespace orograph
