// SPDX-License-Identifier: GPL-3.0-or-later
// A view of plane projection by the parameters that PHIGS gives it (ISO 9592-1), as plain values.
#pragma once

#include "geometry/box.hpp"
#include "geometry/vec.hpp"

namespace orograph {

enum class PhigsProjection { perspective, parallel };

/// World coordinates: the ground frame with exaggerated heights, x east, y north, z up, metres.
/// View reference coordinates (u, v, n), metres from the view reference point: u to the right and
/// v up in the picture, n towards the viewer; right-handed, as the world is.
struct PhigsView {
  PhigsProjection projection = PhigsProjection::perspective;
  Vec3 vrp_m;         ///< view reference point, in the view plane (n = 0)
  Vec3 vpn{0, -1, 0}; ///< view plane normal, the direction of n; of any length
  Vec3 vup{0, 0, 1};  ///< what is upwards (v) once projected along n to the view plane; any length
  Vec3 prp_m{0, 0,
             1}; ///< projection reference point, in (u, v, n), n > 0: the eye; in a parallel
                 ///< projection, a point that lies from the window's centre towards the viewer
  Box2 window_m{{-1, -1}, {1, 1}}; ///< what of the view plane is shown: (umin, vmin), (umax, vmax)
  double front_m = 0.5;            ///< n of the front plane; in perspective nearer than the eye
  double back_m = -1;              ///< n of the back plane, less than that of the front plane
};

} // namespace orograph
