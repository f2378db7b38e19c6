// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/blocks/block_walk.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace orograph {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Spatial {
  double u, v, z;
};
Spatial of(ProfilePoint p) {
  return {p.u, p.v, p.z};
}
Spatial operator-(Spatial a, Spatial b) {
  return {a.u - b.u, a.v - b.v, a.z - b.z};
}
double plan_cross(Spatial a, Spatial b) {
  return a.u * b.v - a.v * b.u;
}

// From the point (0) towards the eye: to it (1) in perspective, without end else.
struct Way {
  Spatial from, to_eye;
  double end;
  Spatial at(double s) const {
    return {from.u + s * to_eye.u, from.v + s * to_eye.v, from.z + s * to_eye.z};
  }
};

Way way_to_eye(const View& view, ProfilePoint p) {
  if (view.is_perspective()) return {of(p), Spatial{0, 0, view.eye_z_m} - of(p), 1};
  return {of(p), {view.x_per_v, -1, view.y_per_v / view.y_per_z}, kInfinity};
}

} // namespace

double BlockWalk::depth_inside_m(ProfilePoint point) const {
  const Way way = way_to_eye(view_, point);
  // What is this close to the point, seen from above, is at it.
  constexpr double kAtPoint_m = 1e-6;
  const double begin = kAtPoint_m / std::hypot(way.to_eye.u, way.to_eye.v);
  double deepest_m = -kInfinity;
  for (const auto& corners : triangles_) {
    const Spatial a = of(corners[0]), ab = of(corners[1]) - a, ac = of(corners[2]) - a;
    const double area = plan_cross(ab, ac);
    if (area == 0) continue;
    // Shares of the corners along the way are linear; within the triangle none is negative.
    double low = begin, high = way.end;
    const auto cut = [&](double at_0, double per_s) {
      if (per_s > 0)
        low = std::max(low, -at_0 / per_s);
      else if (per_s < 0)
        high = std::min(high, -at_0 / per_s);
      else if (at_0 < 0)
        high = -kInfinity;
    };
    const Spatial from_a = way.from - a;
    const double b_0 = plan_cross(from_a, ac) / area, b_s = plan_cross(way.to_eye, ac) / area,
                 c_0 = plan_cross(ab, from_a) / area, c_s = plan_cross(ab, way.to_eye) / area;
    cut(b_0, b_s);
    cut(c_0, c_s);
    cut(1 - b_0 - c_0, -b_s - c_s);
    if (!(low < high)) continue;
    for (const double s : {low, high})
      deepest_m =
          std::max(deepest_m, a.z + (b_0 + s * b_s) * ab.z + (c_0 + s * c_s) * ac.z - way.at(s).z);
  }
  for (const BlockWall& wall : walls_) {
    const Spatial a = of(wall.a), along = of(wall.b) - a;
    const double turn = plan_cross(way.to_eye, along);
    if (turn == 0) continue;
    const Spatial to_a = a - way.from;
    const double s = plan_cross(to_a, along) / turn, t = plan_cross(to_a, way.to_eye) / turn;
    if (!(s > begin && s < way.end && t > 0 && t < 1)) continue;
    const double z = way.at(s).z;
    const double top = std::lerp(wall.a.z, wall.b.z, t),
                 foot = std::lerp(wall.a_foot.z, wall.b_foot.z, t);
    // The surface that begins there tells how far below its edge that is.
    if (z > foot) deepest_m = std::max(deepest_m, top - z);
  }
  return deepest_m;
}

} // namespace orograph
