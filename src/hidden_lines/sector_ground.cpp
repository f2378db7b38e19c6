// SPDX-License-Identifier: GPL-3.0-or-later
#include "hidden_lines/sector_ground.hpp"

#include "hidden_lines/strips.hpp"
#include "placing/sector.hpp"
#include "profiles/seen_ground.hpp"

namespace orograph {

std::vector<SeenGround> ground_of_sectors(const TerrainData& terrain, const PlacedView& placed,
                                          const Style& style, const Instruments& instruments) {
  const Grid* grid = std::get_if<Grid>(&terrain.surface);
  if (!grid || placed.extent.turned_over > 0 || style.occluder != Occluder::surface ||
      instruments.looks_everywhere())
    return {};
  const BlockBounds bounds = block_bounds(*grid);
  std::vector<SeenGround> out;
  for (const Sector& sector : placed.sectors) {
    const double tolerance_y = style.visibility_tolerance_mm > 0
                                   ? tie_tolerance(sector, style.visibility_tolerance_mm).greatest_y
                                   : 0;
    out.push_back(find_seen_ground(
        *grid, bounds, sector.view,
        {page_range(sector), tolerance_y, placed.for_cutters.of_earth_grid, &placed.extent.box}));
  }
  return out;
}

std::optional<SeenGround> looked_at_by_any(const std::vector<SeenGround>& ground) {
  if (ground.empty()) return std::nullopt;
  SeenGround all = ground.front();
  for (const SeenGround& other : ground) all.add(other);
  return all;
}

} // namespace orograph
