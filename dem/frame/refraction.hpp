// SPDX-License-Identifier: GPL-3.0-or-later
// Refraction: light bends down towards the earth, and what it comes from seems lifted.
#pragma once

#include "geometry/vec.hpp"

namespace orograph {

/// How far refraction lifts a place as seen from the eye, in metres along the frame's up: K d^2 /
/// 2R, d the straight distance between the two (ground frame, metres), K the coefficient (0.13 by
/// custom; 0 for none).
///
/// Why d isn't taken on the level: the air's layers bend a level ray with K / R, one of elevation b
/// with K cos(b) / R, so a ray of length d ends K cos(b) d^2 / 2R across from its first direction,
/// which is K d^2 / 2R upright. It is the same wherever the frame's origin is.
///
/// R is the radius that K is a share of. A frame on the ellipsoid has the earth's curvature in its
/// places already, so R bends the light only, and is mean_radius_m at the eye's latitude: one
/// number a view, the mean of Euler's radii over all azimuths and never farther than 0.34 % from
/// one (K = 0.13 at 100 km: 0.35 m of the lift's 102 m, less by far than what K is known to). On a
/// map plane, where the same radius makes the earth's own drop, R is Euler's in the azimuth.
///
/// Up is the frame's, which is the eye's where the origin lies under the eye. With the eye D away
/// from it, up leans by D / R there, and the place goes sideways by that share of the lift.
inline double refraction_lift_m(Vec3 place_m, Vec3 eye_m, double coefficient, double radius_m) {
  const Vec3 from_eye_m = place_m - eye_m;
  return coefficient / (2 * radius_m) * dot(from_eye_m, from_eye_m);
}

} // namespace orograph
