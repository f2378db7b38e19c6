// SPDX-License-Identifier: GPL-3.0-or-later
// View orientation: from the world to view reference coordinates (u, v, n); phigs_view.hpp.
#pragma once

#include "geometry/angle.hpp"
#include "geometry/vec.hpp"

#include <Eigen/Core>

namespace orograph {

/// p -> (u.(p - VRP), v.(p - VRP), n.(p - VRP)) with n = VPN / |VPN|, u = VUP x n / |VUP x n| and
/// v = n x u: a rotation after a translation, determinant +1, so nothing is mirrored. Distances
/// stay as they are. (PHIGS; the rotation is that of Chen and Sabbagh 1983, section 5.3 IV, with
/// VPN towards the viewer.)
/// Throws Error: VPN or VUP of length 0, parallel (within 1e-9 radians), or not finite.
Eigen::Matrix4d view_orientation(Vec3 vrp_m, Vec3 vpn, Vec3 vup);

/// Looks from an eye to a target: the eye goes to the origin, the target to (0, 0, -distance), and
/// what is vertical in the world (z) stays vertical in the picture, upwards; then the picture turns
/// clockwise by `roll` (the head tilts the other way). Equals rotation(n, -roll) after
/// view_orientation(eye, eye - target, vertical). (Angell and Jones 1983, chapter 9, construction
/// of Q, there with y as the vertical and a triad that looks along +z and so is left-handed.)
/// Throws Error: eye and target coincide, or lie above each other; numbers that are not finite.
Eigen::Matrix4d look_at(Vec3 eye_m, Vec3 target_m, Angle roll);

} // namespace orograph
