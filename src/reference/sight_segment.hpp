// SPDX-License-Identifier: GPL-3.0-or-later
// Segments of sight against triangles, in long double, for answers that must be right.
#pragma once

#include "geometry/profile_point.hpp"

#include <array>
#include <cmath>

namespace orograph {

// Points of the profile frame in long double.

struct LongVec {
  long double u = 0, v = 0, z = 0;
};

inline LongVec long_vec(ProfilePoint p) {
  return {p.u, p.v, p.z};
}
inline LongVec operator+(LongVec a, LongVec b) {
  return {a.u + b.u, a.v + b.v, a.z + b.z};
}
inline LongVec operator-(LongVec a, LongVec b) {
  return {a.u - b.u, a.v - b.v, a.z - b.z};
}
inline LongVec operator*(long double s, LongVec a) {
  return {s * a.u, s * a.v, s * a.z};
}
inline long double dot(LongVec a, LongVec b) {
  return a.u * b.u + a.v * b.v + a.z * b.z;
}
inline LongVec cross(LongVec a, LongVec b) {
  return {a.v * b.z - a.z * b.v, a.z * b.u - a.u * b.z, a.u * b.v - a.v * b.u};
}
inline long double length(LongVec a) {
  return std::sqrt(dot(a, a));
}

using LongTriangle = std::array<LongVec, 3>;

/// From the eye to the point that it looks at.
struct SightSegment {
  LongVec from, to;
};

/// Whether the two have a point in common, as signed volumes have it; a triangle's edges and
/// corners belong to it. A segment in the triangle's plane doesn't cross it.
bool crosses(const SightSegment& segment, const LongTriangle& triangle);

/// Whether they have even where both ends of the segment and the triangle's corners are moved by up
/// to `by_m` / 2: the line passes the edges by more than by_m, and the ends are farther than that
/// from the plane.
bool surely_crosses(const SightSegment& segment, const LongTriangle& triangle, long double by_m);

/// 0 where they cross.
long double distance_m(const SightSegment& segment, const LongTriangle& triangle);
long double distance_m(LongVec point, const LongTriangle& triangle);
long double distance_m(LongVec point, const SightSegment& segment);

} // namespace orograph
