// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/sector_ground.hpp"

#include "cli/strips.hpp"
#include "cli/tie_tolerance.hpp"
#include "profiles/find_seen_ground.hpp"

namespace orograph {

std::vector<SeenGround> ground_of_sectors(const Terrain& terrain, const Scene& scene,
                                          const RenderSettings& settings,
                                          const Instruments& instruments) {
  const Grid* grid = std::get_if<Grid>(&terrain.surface);
  if (!grid || grid->is_on_earth() || settings.occluder != Occluder::surface ||
      settings.check > 0 || instruments.looks_everywhere())
    return {};
  std::vector<SeenGround> out;
  for (const Sector& sector : scene.sectors) {
    const double tolerance_y =
        settings.visibility_tolerance_mm > 0
            ? tie_tolerance(sector, settings.visibility_tolerance_mm).greatest_y
            : 0;
    out.push_back(find_seen_ground(*grid, sector.view, {page_range(sector), tolerance_y}));
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
