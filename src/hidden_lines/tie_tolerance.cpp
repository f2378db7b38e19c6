// SPDX-License-Identifier: GPL-3.0-or-later
#include "hidden_lines/tie_tolerance.hpp"

#include "view/sectors.hpp"

#include <algorithm>
#include <limits>

namespace orograph {

TieTolerance tie_tolerance(const Sector& sector, double mm) {
  // Towards the rays beside the eye a length on the page is more and more of Y.
  if (shows_beside(sector.view))
    return {mm, sector.to_page, std::numeric_limits<double>::infinity()};
  double least = std::numeric_limits<double>::infinity();
  for (const Vec3& ray : corner_rays(sector.view))
    least = std::min(least, sector.to_page.mm_per_y({ray.x / ray.z, ray.y / ray.z}));
  return {mm, sector.to_page, mm / least};
}

} // namespace orograph
