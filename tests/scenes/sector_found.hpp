// SPDX-License-Identifier: GPL-3.0-or-later
// What a sector's pass finds of lines, before anything is laid out.
#pragma once

#include "hidden_lines/sector_pass.hpp"
#include "placing/sector.hpp"

#include <limits>
#include <vector>

namespace orograph {

/// REQUIRES that terrain, sector and lines outlive it.
struct SectorFound {
  const LinesOfView& lines;
  SectorLines found;
  XRange range; ///< that the page shows
  LinePictures pictures;
  std::vector<LinePart> visible; ///< skyline and all

  SectorFound(const TerrainData& terrain, const PlacedView& placed, const Sector& sector,
              const LinesOfView& of_view, const Style& style, const Instruments& instruments)
      : lines(of_view), range(page_range(sector)),
        pictures(terrain.surface, placed.reach_m, lines.on_ground.points, sector, lines.listed,
                 range,
                 sector.view.is_perspective() ? sector.view.near_m
                                              : -std::numeric_limits<double>::infinity()) {
    Counts counts;
    StageSeconds seconds;
    found = sector_pass(terrain, placed, sector, lines, nullptr, style, instruments, nullptr,
                        {counts, seconds}, [] {});
    pictures.set_found(found.found);
    visible = found.visible;
    visible.insert(visible.end(), found.skyline.begin(), found.skyline.end());
    join(visible);
  }
};

} // namespace orograph
