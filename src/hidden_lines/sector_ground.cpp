// SPDX-License-Identifier: GPL-3.0-or-later
#include "hidden_lines/sector_ground.hpp"

#include "hidden_lines/strips.hpp"
#include "placing/sector.hpp"
#include "profiles/seen_ground.hpp"

namespace orograph {
namespace {

// Of a view that shows all of a grid with few voids nothing is passed over but what is hidden. Of
// eleven terrains from 5 to 60 degrees, those with less than this behind ridges take 0.80 to 1.06
// times as long if all of them is looked at, in degrees 0.80 to 1.02 (docs/decisions/0018).
bool pays_to_find(const Grid& grid, const PlacedView& placed) {
  constexpr double kLeastBehindRidges = 0.25, kFewVoids = 0.1;
  const bool is_all_shown = placed.view.frames_terrain && placed.sectors.size() == 1;
  const auto vertices = static_cast<double>(grid.size());
  return !is_all_shown || static_cast<double>(placed.extent.valid) < (1 - kFewVoids) * vertices ||
         share_behind_ridges(grid, placed.view) >= kLeastBehindRidges;
}

} // namespace

std::vector<SeenGround> ground_of_sectors(const TerrainData& terrain, const PlacedView& placed,
                                          const Style& style, const Instruments& instruments) {
  const Grid* grid = std::get_if<Grid>(&terrain.surface);
  if (!grid || placed.extent.turned_over > 0 || style.occluder != Occluder::surface ||
      instruments.looks_everywhere())
    return {};
  if (!instruments.ground_always && !pays_to_find(*grid, placed)) return {};
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
