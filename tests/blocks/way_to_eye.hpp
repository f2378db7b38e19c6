// SPDX-License-Identifier: GPL-3.0-or-later
// Rays from points to the eye, against triangles in space.
#pragma once

#include "geometry/profile_point.hpp"
#include "geometry/vec.hpp"
#include "solids/shadow.hpp"
#include "view/view.hpp"

#include <array>
#include <limits>

namespace orograph {

/// The way from a point to the eye, as far as it goes.
struct Way {
  Vec3 from, step;
  double end;
};

inline Way way_to_eye(const View& view, ProfilePoint p) {
  if (view.is_perspective()) return {as_vec(p), Vec3{0, 0, view.eye_z_m} - as_vec(p), 1};
  return {as_vec(p),
          {view.x_per_v, -1, view.y_per_v / view.y_per_z},
          std::numeric_limits<double>::infinity()};
}

/// Whether a way passes a triangle, more than `begin` of it away.
inline bool passes(const Way& way, const std::array<Vec3, 3>& t, double begin) {
  const Vec3 ab = t[1] - t[0], ac = t[2] - t[0], normal = cross(ab, ac);
  const double along = dot(way.step, normal);
  if (along == 0) return false;
  const double s = dot(t[0] - way.from, normal) / along;
  if (!(s > begin && s < way.end)) return false;
  const Vec3 at = way.from + s * way.step;
  const auto side = [&](const Vec3& a, const Vec3& b) {
    return dot(cross(b - a, at - a), normal) >= 0;
  };
  return side(t[0], t[1]) && side(t[1], t[2]) && side(t[2], t[0]);
}

} // namespace orograph
