// SPDX-License-Identifier: GPL-3.0-or-later
#include "placing/near_skyline.hpp"

#include <cmath>

namespace orograph {
namespace {

double distance_m(const GroundAhead& column, std::size_t i) {
  return column.v_m[i] * std::hypot(1, column.x);
}

// Whether most columns have their skyline within this, from so far above the eye, with ground that
// it may hide beyond `world_m`.
bool is_near(const View& view, const std::vector<GroundAhead>& ahead, double within_m,
             double world_m, double above_m) {
  std::size_t near = 0;
  for (const GroundAhead& column : ahead) {
    const auto at = column.skyline(view, above_m);
    if (at < 0 || distance_m(column, column.v_m.size() - 1) <= world_m) continue;
    if (distance_m(column, static_cast<std::size_t>(at)) <= within_m) ++near;
  }
  return 2 * near > ahead.size();
}

} // namespace

std::optional<NearSkyline> near_skyline(const View& view, const std::vector<GroundAhead>& ahead,
                                        double cell_m, double eye_height_m) {
  const double feet_m = 2 * cell_m, world_m = 10 * cell_m;
  if (!(eye_height_m > 0) || !is_near(view, ahead, feet_m, world_m, 0)) return std::nullopt;
  NearSkyline out{feet_m, eye_height_m, std::nullopt};
  for (double height_m = 2 * eye_height_m; height_m <= 2 * cell_m && !out.clear_of_height_m;
       height_m *= 2)
    if (!is_near(view, ahead, world_m, world_m, height_m - eye_height_m))
      out.clear_of_height_m = height_m;
  return out;
}

} // namespace orograph
