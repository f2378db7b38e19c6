// SPDX-License-Identifier: GPL-3.0-or-later
// Which rows are measured, what they are called and what they promise.
#include "measure/fragmentation.hpp"

#include <fmt/format.h>

namespace orograph {

std::string name_of(const FragmentationRow& row) {
  return fmt::format("{}{} hide{}, from {}/{}, {} profiles",
                     row.scene == "terrain" ? "" : row.scene + ", ",
                     row.occluder == Occluder::surface ? "the surface" : "profiles",
                     row.occluder == Occluder::surface ? "s" : "", row.azimuth_deg,
                     row.elevation_deg, row.profiles);
}

std::vector<FragmentationRow> fragmentation_rows(const FragmentationSpec& spec) {
  std::vector<FragmentationRow> rows;
  for (const Occluder occluder : {Occluder::profiles, Occluder::surface})
    for (const double azimuth_deg : spec.azimuths_deg)
      for (const double elevation_deg : spec.elevations_deg)
        for (const int profiles : spec.profiles) {
          FragmentationRow& row = rows.emplace_back();
          row.scene = "terrain";
          row.occluder = occluder;
          row.azimuth_deg = azimuth_deg;
          row.elevation_deg = elevation_deg;
          row.profiles = profiles;
        }
  return rows;
}

std::string broken_promise(const FragmentationRow& row) {
  if (!row.least) return "";
  const HorizonDifferences& found = row.least->differences;
  if (found.fragments > 0)
    return fmt::format("{} pieces of its horizons could be joined to their neighbours",
                       found.fragments);
  if (found.wrong > 0)
    return fmt::format("its horizons differ from the true ones in {} places, and not by ties",
                       found.wrong);
  return "";
}

} // namespace orograph
