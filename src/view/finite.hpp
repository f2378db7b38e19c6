// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers of a view that aren't numbers.
#pragma once

#include "geometry/error.hpp"
#include "geometry/vec.hpp"

#include <cmath>
#include <string>

namespace orograph {

/// Throws Error, which begins with `what`, if it is infinite or not a number.
inline void require_finite(double value, const std::string& what) {
  if (!std::isfinite(value)) throw Error(what + " is not a finite number", "give finite numbers");
}
inline void require_finite(Vec2 value, const std::string& what) {
  require_finite(value.x, what);
  require_finite(value.y, what);
}
inline void require_finite(Vec3 value, const std::string& what) {
  require_finite(Vec2{value.x, value.y}, what);
  require_finite(value.z, what);
}

} // namespace orograph
