// SPDX-License-Identifier: GPL-3.0-or-later
#include "view/sectors.hpp"

#include <algorithm>
#include <cmath>

namespace orograph {
namespace {

// Share of depth in a ray's length, 3 degrees: nearer to the plane beside the eye, the near plane
// that suits flatter views would cut away ground that the page shows.
constexpr double kLeastDepthShare = 0.05;

} // namespace

Vec3 ray_of_picture(const View& view, Vec2 picture) {
  return inverse(view.to_picture).of({picture.x, picture.y, 1});
}

std::array<Vec3, 4> corner_rays(const View& view) {
  const Homography to_plane = inverse(view.to_picture);
  const auto& [low, high] = view.window;
  return {to_plane.of({low.x, low.y, 1}), to_plane.of({high.x, low.y, 1}),
          to_plane.of({high.x, high.y, 1}), to_plane.of({low.x, high.y, 1})};
}

bool shows_beside(const View& view) {
  if (!view.is_perspective()) return false;
  // Depth is linear over the picture and its share of a ray's length falls towards the sides of a
  // convex cone: it is least at a corner.
  return std::ranges::any_of(corner_rays(view),
                             [](Vec3 ray) { return ray.z < kLeastDepthShare * length(ray); });
}

double greatest_y_ahead(double x) {
  return std::sqrt(1 / (kLeastDepthShare * kLeastDepthShare) - 1 - x * x);
}

double near_plane_m(const View& view, double cell_m) {
  if (!view.is_perspective()) return 0;
  return (shows_beside(view) ? kNearShareBetweenSectors : kNearShareOfCell) * cell_m;
}

// The ray (X, Y, 1) of the one is (-X, Y, -1) of the other.
Homography homography_behind(const Homography& ahead) {
  Homography behind = ahead;
  for (const std::size_t i : {0, 2, 3, 5, 6, 8}) behind.m[i] *= -1;
  return behind;
}

View sector_behind(const View& view) {
  View behind = view;
  behind.forward = -1.0 * view.forward;
  behind.right = -1.0 * view.right;
  behind.to_picture = homography_behind(view.to_picture);
  return behind;
}

} // namespace orograph
