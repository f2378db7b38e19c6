// SPDX-License-Identifier: GPL-3.0-or-later
// Places and ways in the profile frame, as walks through sheets and blocks reckon with them.
#pragma once

#include "view/view.hpp"

namespace orograph {

struct Spatial {
  double u, v, z;
};
inline Spatial of(ProfilePoint p) {
  return {p.u, p.v, p.z};
}
inline Spatial operator-(Spatial a, Spatial b) {
  return {a.u - b.u, a.v - b.v, a.z - b.z};
}
/// Of both seen from above.
inline double plan_cross(Spatial a, Spatial b) {
  return a.u * b.v - a.v * b.u;
}

} // namespace orograph
