// SPDX-License-Identifier: GPL-3.0-or-later
#include "placing/place_waterlines.hpp"

#include "geometry/on_all_cores.hpp"
#include "view/view.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace orograph {
namespace {

// By eye, as engravers did: so that the shore's shadow fades into the open water.
constexpr int kLines = 6;
constexpr double kGrowth = 1.4;
// From low, lines lie close behind one another: they are placed by the mean of both directions, but
// for views along the water, where they would go out too far to the sides.
constexpr double kMostDepth = 2;

} // namespace

Isolines place_waterlines(const PlacedView& placed, const Surface& surface, double pen_width_mm) {
  const View& view = placed.view;
  const EdgeEnds ends(surface, view);
  std::vector<double> mm_per_m; // at shores in the frame
  for (const SurfaceEdge& edge : placed.level.shores) {
    throw_if_stopped(mm_per_m.size());
    const ProfilePoint at = ends(edge).from;
    const Vec3 image = placed.on_page(at);
    const double away_m = placed.panorama ? std::hypot(at.u, at.v) : at.v;
    if (!(image.z > 0) || (view.is_perspective() && away_m < view.near_m)) continue;
    const Vec2 mm{image.x / image.z, image.y / image.z};
    if (mm.x < placed.frame_mm.low.x || mm.x > placed.frame_mm.high.x ||
        mm.y < placed.frame_mm.low.y || mm.y > placed.frame_mm.high.y)
      continue;
    const Vec2 ahead = placed.panorama ? (1 / away_m) * Vec2{at.u, at.v} : Vec2{0, 1};
    const double across = placed.mm_per_step(at, {ahead.y, -ahead.x, 0}),
                 along = placed.mm_per_step(at, {ahead.x, ahead.y, 0});
    mm_per_m.push_back(std::max(std::sqrt(across * along), across / kMostDepth));
  }
  if (mm_per_m.empty()) return {};
  const auto middle = mm_per_m.begin() + static_cast<std::ptrdiff_t>(mm_per_m.size() / 2);
  std::nth_element(mm_per_m.begin(), middle, mm_per_m.end());
  if (!(*middle > 0)) return {};
  std::vector<double> distances_m;
  double step_m = kPenWidthsApart * pen_width_mm / *middle, distance_m = 0;
  for (int i = 0; i < kLines; ++i, step_m *= kGrowth) distances_m.push_back(distance_m += step_m);
  return waterlines(surface, placed.level, distances_m);
}

} // namespace orograph
