// SPDX-License-Identifier: GPL-3.0-or-later
// Points of the profile frame in long double, for answers that must be right.
#pragma once

#include "geometry/profile_point.hpp"

#include <cmath>

namespace orograph {

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

} // namespace orograph
