// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/fragmentation/fragmentation_row.hpp"

#include "geometry/error.hpp"

#include <fmt/format.h>

namespace orograph {

std::string name_of(const FragmentationRow& row) {
  return fmt::format("{}{} hide{}, from {}/{}, {} profiles",
                     row.scene == "terrain" ? "" : row.scene + ", ",
                     row.occluder == Occluder::surface ? "the surface" : "profiles",
                     row.occluder == Occluder::surface ? "s" : "", row.azimuth_deg,
                     row.elevation_deg, row.profiles);
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

void check_promises(const std::vector<FragmentationRow>& rows) {
  for (const FragmentationRow& row : rows)
    if (const std::string broken = broken_promise(row); !broken.empty())
      throw Error(fmt::format("collapse doesn't keep the horizon at its least size in the row "
                              "'{}': {}",
                              name_of(row), broken),
                  "please report it with the terrain and the command");
}

} // namespace orograph
