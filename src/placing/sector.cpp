// SPDX-License-Identifier: GPL-3.0-or-later
#include "placing/sector.hpp"

#include "view/sectors.hpp"

#include <algorithm>

namespace orograph {

XRange page_range(const Sector& sector) {
  if (shows_beside(sector.view)) return {-kInfinity, kInfinity};
  XRange range{kInfinity, -kInfinity};
  for (const Vec3& ray : corner_rays(sector.view)) {
    range.begin = std::min(range.begin, ray.x / ray.z);
    range.end = std::max(range.end, ray.x / ray.z);
  }
  // The corners are rounded, and so are places in the picture.
  const double beside = 1e-6 * (range.end - range.begin);
  return {range.begin - beside, range.end + beside};
}

TieTolerance tie_tolerance(const Sector& sector, double mm) {
  // Towards the rays beside the eye a length on the page is more and more of Y.
  if (shows_beside(sector.view)) return {mm, sector.to_page, kInfinity};
  double least = kInfinity;
  for (const Vec3& ray : corner_rays(sector.view))
    least = std::min(least, sector.to_page.mm_per_y({ray.x / ray.z, ray.y / ray.z}));
  return {mm, sector.to_page, mm / least};
}

} // namespace orograph
