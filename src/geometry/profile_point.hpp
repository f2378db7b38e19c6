// SPDX-License-Identifier: GPL-3.0-or-later
// A point in the profile frame of a view (docs/how-it-works.md).
#pragma once

namespace orograph {

/// u to the right, v along depth, both in metres from the depth origin; z the exaggerated height
/// in metres.
struct ProfilePoint {
  double u = 0, v = 0, z = 0;
};

/// The point at share t of the straight line from a to b; exactly a at 0 and b at 1.
inline ProfilePoint point_between(ProfilePoint a, ProfilePoint b, double t) {
  if (t >= 1) return b;
  return {a.u + t * (b.u - a.u), a.v + t * (b.v - a.v), a.z + t * (b.z - a.z)};
}

/// Where along a line, whose ends lie at depths v_begin and v_end, the point is that stands at
/// `share` of the way along the line's perspective picture; exactly 0 at 0 and 1 at 1. (1/v is
/// linear along the picture.) In a parallel picture the two shares are the same.
inline double share_in_depth(double share, double v_begin, double v_end) {
  const double far_weight = share * v_begin;
  return far_weight / ((1 - share) * v_end + far_weight);
}

} // namespace orograph
