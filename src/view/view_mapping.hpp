// SPDX-License-Identifier: GPL-3.0-or-later
// View mapping: from view reference coordinates (u, v, n) to a canonical volume; and from the
// canonical volume of perspective to that of parallel projection. After Paoluzzi 2003, pipeline 3D,
// sections "parallel case", "perspective case" and 9.2.6, with its misprints put right.
#pragma once

#include "view/phigs_view.hpp"

#include <Eigen/Core>

namespace orograph {

/// The volume that everything shown is mapped to. x is to the right, y up, z towards the viewer.
/// - parallel: -1 <= x <= 1, -1 <= y <= 1, -1 <= z <= 0;
/// - perspective: z <= x <= -z, z <= y <= -z, -1 <= z <= z_min, with the eye at the origin and
///   -1 < z_min < 0.
/// The back plane is z = -1 in both; the front plane is z = 0 or z = z_min.
struct CanonicalVolume {
  PhigsProjection projection = PhigsProjection::parallel;
  double z_min = 0; ///< perspective only
};

// All of the following take VRP, VPN and VUP to be used up, and throw Error if the view volume is
// none: numbers that are not finite; an empty window; front plane not nearer than the back plane;
// PRP in the view plane or behind it (n <= 0), which in perspective is an eye on the view plane and
// in a parallel projection a direction that lies in it; in perspective, a front plane that isn't
// beyond the eye.

/// With c the window's centre, p the PRP, F and B the front and back plane: z_min is
/// -(p_n - F) / (p_n - B) in perspective.
CanonicalVolume canonical_volume(const PhigsView& view);

/// S(2 / (umax - umin), 2 / (vmax - vmin), 1 / (F - B)) T(-c_u, -c_v, -F) H, where H shears by
/// -d_u / d_n and -d_v / d_n, d = c - p being the direction of projection: (u, v, n) in the oblique
/// view volume goes to the canonical volume of parallel projection, lines along d to lines along z.
/// REQUIRES view.projection is parallel.
Eigen::Matrix4d parallel_mapping(const PhigsView& view);

/// S2 S1 H T(-p): the eye to the origin; the shear by -d_u / d_n and -d_v / d_n, d = c - p, which
/// brings the pyramid's axis onto the z axis; S1 = S(2 p_n / (umax - umin), 2 p_n / (vmax - vmin),
/// 1), which makes its sides slope by 1; S2, all by 1 / (p_n - B), which brings the back plane to
/// z = -1. (u, v, n) goes to the canonical volume of perspective; w stays 1.
/// REQUIRES view.projection is perspective.
Eigen::Matrix4d perspective_mapping(const PhigsView& view);

/// The one of the two that the view asks for.
Eigen::Matrix4d view_mapping(const PhigsView& view);

/// Canonical volume of perspective to that of parallel projection: (x, y, z, 1) ->
/// (x, y, (z - z_min) / (1 + z_min), -z), equation (9.1). The back plane z = -1 stays point by
/// point, the front plane goes to z = 0, the eye to infinity. w of the image is the distance from
/// the eye along n over that of the back plane: positive in front of the eye.
/// REQUIRES -1 < z_min < 0.
Eigen::Matrix4d perspective_transformation(double z_min);

} // namespace orograph
