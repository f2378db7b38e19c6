// SPDX-License-Identifier: GPL-3.0-or-later
// On which side of a line on the ground the eye is.
#pragma once

#include "geometry/profile_point.hpp"
#include "view/view.hpp"

namespace orograph {

/// By how much the line from -> to goes to the left, seen from the eye: positive where the eye is
/// on its left, seen from above. The same, but for its sign, of to -> from.
inline double way_to_left(const View& view, ProfilePoint from, ProfilePoint to) {
  return view.is_perspective() ? from.u * to.v - from.v * to.u
                               : (from.u - to.u) + view.x_per_v * (from.v - to.v);
}
/// Where the eye is of that line: 1 left, -1 right, 0 on it to rounding.
inline int eye_side(const View& view, ProfilePoint from, ProfilePoint to) {
  const double turn = way_to_left(view, from, to);
  return turn > 0 ? 1 : turn < 0 ? -1 : 0;
}

} // namespace orograph
