// SPDX-License-Identifier: GPL-3.0-or-later
// Turning a profile frame about its upright through the eye.
#pragma once

#include "geometry/profile_point.hpp"

namespace orograph {

/// From one profile frame to another with the same origin: the angle from the second's forward
/// direction clockwise to the first's.
struct Turn {
  double cos = 1, sin = 0;

  ProfilePoint operator()(ProfilePoint p) const {
    return {cos * p.u + sin * p.v, cos * p.v - sin * p.u, p.z};
  }
  Turn back() const { return {cos, -sin}; }
};

} // namespace orograph
