// SPDX-License-Identifier: GPL-3.0-or-later
// What lies on one side of a plane.
#pragma once

#include "geometry/vec.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace orograph {

/// normal . p <= offset, in the ground frame (true heights, metres). The normal is finite, of any
/// length but 0.
struct HalfSpace {
  Vec3 normal;
  double offset = 0;
};

/// Roundings (2^-52 of a coordinate) within which a vertex counts as on a plane. A new vertex is
/// rounded by about one: pieces that are some dozens wide aren't turned over by it.
constexpr double kRoundingsOnPlane = 64;

/// How far a point is beyond the plane, times the normal's length; rounded.
inline double beyond(const HalfSpace& space, const Vec3& p) {
  return dot(space.normal, p) - space.offset;
}

/// -1 within the half-space, 1 beyond it, 0 on the plane: where `beyond` is within 64 roundings of
/// what it is summed from.
inline int side_of(const HalfSpace& space, const Vec3& p) {
  const Vec3& n = space.normal;
  const double by = beyond(space, p);
  const double size = (std::abs(n.x) + std::abs(n.y)) * std::max(std::abs(p.x), std::abs(p.y)) +
                      std::abs(n.z * p.z) + std::abs(space.offset);
  if (std::abs(by) <= kRoundingsOnPlane * std::numeric_limits<double>::epsilon() * size) return 0;
  return by < 0 ? -1 : 1;
}

} // namespace orograph
