// SPDX-License-Identifier: GPL-3.0-or-later
// A place that a user names, for the eye or for what it looks at.
#pragma once

#include "geometry/vec.hpp"

#include <optional>

namespace orograph {

struct GivenPlace {
  double x = 0, y = 0; ///< map coordinates, or longitude and latitude in degrees
  std::optional<double>
      z; ///< above the datum of the file's heights, in their unit; none: no height

  GivenPlace(double east, double north) : x(east), y(north) {}
  GivenPlace(Vec3 place) : x(place.x), y(place.y), z(place.z) {}
  bool operator==(const GivenPlace&) const = default;
};

} // namespace orograph
