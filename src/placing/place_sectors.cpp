// SPDX-License-Identifier: GPL-3.0-or-later
#include "placing/place_sectors.hpp"

#include "profiles/cut_surface.hpp"
#include "view/sectors.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

namespace orograph {
namespace {

// Those between which the terrain lies.
std::pair<double, double> depths_of(const PlacedView& placed, const Surface& surface,
                                    const View& view) {
  const SurfaceCutter cutter(surface, view, placed.level.triangles, placed.for_cutters);
  return {cutter.nearest_m(), cutter.farthest_m()};
}

// All have the same, so that profiles go on from one to the next.
void share_profiles(PlacedView& placed) {
  for (Sector& sector : placed.sectors)
    for (std::size_t i = 0; i < placed.depths_m.size(); ++i)
      if (placed.depths_m[i] < sector.farthest_m)
        sector.profiles.push_back({placed.depths_m[i], static_cast<std::int32_t>(i)});
}

// Those of the two sides of the eye on which there is something.
std::vector<Sector> plane_sectors(const PlacedView& placed) {
  Sector ahead;
  ahead.view = placed.view;
  ahead.to_page = placed.to_page;
  ahead.nearest_m = placed.nearest_m;
  ahead.farthest_m = placed.farthest_m;
  std::vector<Sector> sectors{ahead};
  double nearest_m = placed.nearest_m;
  for (const StandingSolid& solid : placed.solids)
    for (const Vec3& vertex : solid.vertices_m)
      nearest_m = std::min(nearest_m, to_profile_frame(placed.view, vertex).v);
  if (shows_beside(placed.view) && nearest_m < -placed.view.near_m) {
    Sector behind;
    behind.behind = true;
    behind.to_view = {-1, 0};
    behind.view = sector_behind(placed.view);
    behind.to_page = homography_behind(placed.to_page);
    behind.nearest_m = -placed.farthest_m;
    behind.farthest_m = -placed.nearest_m;
    sectors.push_back(behind);
    sectors.front().keeps_strip = placed.view.near_m < kNearShareOfCell * placed.cell_m;
    if (sectors.front().keeps_strip)
      for (Sector& sector : sectors)
        sector.view.drawn_from_m = kNearPlanesAhead * placed.view.near_m;
  }
  for (Sector& sector : sectors) {
    for (std::size_t i = 0; i < placed.depths_m.size(); ++i) {
      const double depth = sector.behind ? -placed.depths_m[i] : placed.depths_m[i];
      if (sectors.size() == 1 || depth > 0)
        sector.profiles.push_back({depth, static_cast<std::int32_t>(i)});
    }
    if (sector.behind) std::reverse(sector.profiles.begin(), sector.profiles.end());
  }
  return sectors;
}

} // namespace

void find_depths(PlacedView& placed, const Surface& surface) {
  if (!placed.panorama) {
    std::tie(placed.nearest_m, placed.farthest_m) = depths_of(placed, surface, placed.view);
    return;
  }
  placed.sectors = sectors_of(*placed.panorama, placed.view);
  for (Sector& sector : placed.sectors)
    std::tie(sector.nearest_m, sector.farthest_m) = depths_of(placed, surface, sector.view);
  placed.nearest_m = std::ranges::min(placed.sectors, {}, &Sector::nearest_m).nearest_m;
  placed.farthest_m = std::ranges::max(placed.sectors, {}, &Sector::farthest_m).farthest_m;
}

void place_sectors(PlacedView& placed) {
  if (!placed.panorama) {
    placed.sectors = plane_sectors(placed);
    return;
  }
  if (placed.sectors.empty()) placed.sectors = sectors_of(*placed.panorama, placed.view);
  share_profiles(placed);
}

} // namespace orograph
