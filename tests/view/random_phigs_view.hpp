// SPDX-License-Identifier: GPL-3.0-or-later
// Views of plane projection at random, and what a view makes of a point by the definition of
// projection: a straight line through the point that meets the view plane. No matrices.
#pragma once

#include "tests/support/random.hpp"
#include "view/phigs_view.hpp"

#include <array>

namespace orograph {

inline Vec3 random_point(Random& random, double reach) {
  return {random.between(-reach, reach), random.between(-reach, reach),
          random.between(-reach, reach)};
}

/// Not near zero length.
inline Vec3 random_direction(Random& random) {
  for (;;) {
    const Vec3 d = random_point(random, 1);
    if (length(d) > 0.2) return random.pick({1e-3, 1.0, 50.0}) * d;
  }
}

/// At least a hundredth of a radian aside from `direction`.
inline Vec3 random_aside(Random& random, Vec3 direction) {
  for (;;) {
    const Vec3 d = random_direction(random);
    if (length(cross(d, direction)) > 0.01 * length(d) * length(direction)) return d;
  }
}

/// Windows on and off the axis, planes on either side of the view plane.
inline PhigsView random_phigs_view(Random& random, PhigsProjection projection) {
  PhigsView view;
  view.projection = projection;
  view.vrp_m = random_point(random, 1000);
  view.vpn = random_direction(random);
  view.vup = random_aside(random, view.vpn);
  const double size = random.pick({1.0, 30.0, 1000.0});
  const Vec2 middle{random.between(-size, size), random.between(-size, size)};
  const Vec2 half{random.between(0.1, 1) * size, random.between(0.1, 1) * size};
  view.window_m = {middle - half, middle + half};
  view.prp_m = {random.between(-size, size), random.between(-size, size),
                random.between(0.3, 3) * size};
  view.front_m = view.prp_m.z - random.between(0.05, 4) * size;
  view.back_m = view.front_m - random.between(0.1, 10) * size;
  return view;
}

struct Axes {
  Vec3 u, v, n;
};

inline Axes axes_of(const PhigsView& view) {
  const Vec3 n = (1 / length(view.vpn)) * view.vpn;
  const Vec3 flat = cross(view.vup, n);
  const Vec3 u = (1 / length(flat)) * flat;
  return {u, cross(n, u), n};
}

inline Vec3 world_of(const PhigsView& view, Vec3 uvn) {
  const auto [u, v, n] = axes_of(view);
  return view.vrp_m + uvn.x * u + uvn.y * v + uvn.z * n;
}

/// Away from the viewer, in (u, v, n), with -1 along n: from the PRP to the window's centre.
inline Vec3 projectors_of(const PhigsView& view) {
  const Vec2 centre = view.window_m.centre();
  return (1 / view.prp_m.z) * (Vec3{centre.x, centre.y, 0} - view.prp_m);
}

/// The corners of the view volume in (u, v, n): bit 0 right, bit 1 upper, bit 2 front.
inline std::array<Vec3, 8> corners_of(const PhigsView& view) {
  std::array<Vec3, 8> corners;
  for (int i = 0; i < 8; ++i) {
    const Vec3 on_plate{(i & 1) ? view.window_m.high.x : view.window_m.low.x,
                        (i & 2) ? view.window_m.high.y : view.window_m.low.y, 0};
    const double n = (i & 4) ? view.front_m : view.back_m;
    corners[i] = view.projection == PhigsProjection::perspective
                     ? view.prp_m + (1 - n / view.prp_m.z) * (on_plate - view.prp_m)
                     : on_plate - n * projectors_of(view);
  }
  return corners;
}

/// A point of the view volume, in (u, v, n).
inline Vec3 point_within(Random& random, const PhigsView& view) {
  const auto corners = corners_of(view);
  const double across = random.share(), upward = random.share(), nearer = random.share();
  Vec3 point;
  for (int i = 0; i < 8; ++i)
    point = point + ((i & 1) ? across : 1 - across) * ((i & 2) ? upward : 1 - upward) *
                        ((i & 4) ? nearer : 1 - nearer) * corners[i];
  return point;
}

/// Where the picture of a world point is on the page: the window fills the viewport.
inline Vec2 page_by_definition(const PhigsView& view, const Box2& viewport_mm, Vec3 world) {
  const auto [u, v, n] = axes_of(view);
  const Vec3 from_vrp = world - view.vrp_m;
  const Vec3 p{dot(from_vrp, u), dot(from_vrp, v), dot(from_vrp, n)};
  const Vec3 on_plate = view.projection == PhigsProjection::perspective
                            ? view.prp_m + (view.prp_m.z / (view.prp_m.z - p.z)) * (p - view.prp_m)
                            : p + p.z * projectors_of(view);
  const Box2& window = view.window_m;
  return {viewport_mm.low.x + (on_plate.x - window.low.x) / window.width() * viewport_mm.width(),
          viewport_mm.low.y +
              (window.high.y - on_plate.y) / window.height() * viewport_mm.height()};
}

} // namespace orograph
