// SPDX-License-Identifier: GPL-3.0-or-later
#include "solids/shadow.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

namespace orograph {
namespace {

// The upright plane through a and b, with what is on the left of a -> b, seen from above, inside.
ShadowPlane upright_plane(Vec3 a, Vec3 b) {
  return {{a.y - b.y, b.x - a.x, 0}, a};
}

ShadowPlane inside_out(ShadowPlane plane) {
  plane.normal = -1.0 * plane.normal;
  return plane;
}

// Right of the ray through a point, in the visibility plane.
ShadowPlane right_of(const View& view, Vec3 p) {
  if (view.is_perspective()) return {{p.y, -p.x, 0}, p};
  return {{1, view.x_per_v, 0}, p};
}

} // namespace

SightRays sight_rays(const View& view) {
  if (view.is_perspective()) return {{0, 0, view.eye_z_m}};
  return {{-view.x_per_v * view.y_per_z, view.y_per_z, -view.y_per_v}, true};
}

Vec3 ray_plane_normal(const SightRays& rays, Vec3 a, Vec3 b) {
  return rays.parallel ? cross(rays.from, b - a) : cross(a - rays.from, b - rays.from);
}

std::optional<Share> hidden_share(const Shadow& shadow, Vec3 from, Vec3 to) {
  Share share{0, 1};
  for (const ShadowPlane& plane : shadow.planes) {
    const double a = plane.at(from), b = plane.at(to);
    if (a < 0 && b < 0) return std::nullopt;
    if (a < 0) share.begin = std::max(share.begin, a / (a - b));
    if (b < 0) share.end = std::min(share.end, a / (a - b));
  }
  return share.begin < share.end ? std::optional(share) : std::nullopt;
}

Shadow triangle_shadow(const SightRays& rays, const std::array<Vec3, 3>& corners,
                       const std::array<std::uint32_t, 3>& order, double touching_m) {
  Shadow shadow;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const bool rises = order[i] < order[j];
    // Always from the lower number to the higher: rounding is the same for both triangles.
    const Vec3 &a = corners[rises ? i : j], &b = corners[rises ? j : i];
    const ShadowPlane plane{ray_plane_normal(rays, a, b), a};
    shadow.planes[i] = rises ? inside_out(plane) : plane;
  }
  const auto& [a, b, c] = corners;
  const Vec3 normal = cross(b - a, c - a);
  shadow.planes[3] = {-1.0 * normal, a, touching_m * length(normal)};
  return shadow;
}

Shadow edge_shadow(const View& view, const SightRays& rays, Vec3 left, Vec3 right,
                   double touching_m) {
  const Vec3 down = ray_plane_normal(rays, left, right);
  return {{right_of(view, left), inside_out(right_of(view, right)), upright_plane(left, right),
           ShadowPlane{down, left, touching_m * length(down)}}};
}

Shadow buried_under(std::array<Vec3, 3> corners, double touching_m) {
  Shadow shadow;
  const auto before = [](const Vec3& a, const Vec3& b) {
    return std::tie(a.x, a.y) < std::tie(b.x, b.y);
  };
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 &a = corners[i], &b = corners[(i + 1) % 3];
    shadow.planes[i] = before(a, b) ? upright_plane(a, b) : inside_out(upright_plane(b, a));
  }
  const auto& [a, b, c] = corners;
  const Vec3 normal = cross(b - a, c - a);
  shadow.planes[3] = {-1.0 * normal, a, touching_m * length(normal)};
  return shadow;
}

} // namespace orograph
