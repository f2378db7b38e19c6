// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/tie_tolerance.hpp"

#include "view/place_view.hpp"

#include <algorithm>
#include <limits>

namespace orograph {

TieTolerance tie_tolerance(const Scene& scene, double mm) {
  double least = std::numeric_limits<double>::infinity();
  for (const Vec2& corner : shown_corners(scene.view))
    least = std::min(least, scene.to_page.mm_per_y(corner));
  return {mm, scene.to_page, mm / least};
}

} // namespace orograph
