// SPDX-License-Identifier: GPL-3.0-or-later
// Model transforms: from coordinates in which a thing is defined (SETUP) to the world's (ACTUAL).
// Matrices act on columns (x, y, z, w), so in a product the rightmost acts first.
// Sources: Ian O. Angell and Brian J. Jones, Advanced graphics with the BBC model B microcomputer,
// 1983; Pee-Hong Chen and L. David Sabbagh, Technical Report 146, Indiana University, 1983;
// Alberto Paoluzzi, Geometric programming for computer-aided design, 2003.
#pragma once

#include "geometry/angle.hpp"
#include "geometry/vec.hpp"

#include <Eigen/Core>

#include <initializer_list>

namespace orograph {

/// T(d): p -> p + d. d finite. (Angell and Jones 1983, example 9.1, matrix B.)
Eigen::Matrix4d translation(Vec3 by);

/// S(s): (x, y, z) -> (s_x x, s_y y, s_z z). s finite; a factor of 0 is no model transform, see
/// `model_transform`. (Chen and Sabbagh 1983, section 5.3 II.)
Eigen::Matrix4d scaling(Vec3 factors);

/// Rotation about the axis through the origin, counterclockwise for who looks against the axis.
/// With a the unit axis: p -> a (a.p) + cos(angle) (p - a (a.p)) + sin(angle) a x p (Rodrigues).
/// Exact at multiples of 90 degrees about a coordinate axis. Throws Error: an axis of length 0 or
/// not finite, an angle not finite.
Eigen::Matrix4d rotation(Vec3 axis, Angle angle);

/// H_z: (x, y, z) -> (x + x_per_z z, y + y_per_z z, z); points with z = 0 stay. Factors finite.
/// (Paoluzzi 2003, pipeline 3D, parallel case.)
Eigen::Matrix4d shear_along_z(double x_per_z, double y_per_z);

/// The product of transforms that are listed in the order in which they act. The empty list is the
/// identity. Throws Error if the product is not affine, not finite, or singular: if the box of unit
/// vectors becomes flat to rounding, its volume below 1e-14 of the product of its edges.
Eigen::Matrix4d model_transform(std::initializer_list<Eigen::Matrix4d> first_to_last);

/// Throws the same Errors for a matrix that came in some other way.
void require_model(const Eigen::Matrix4d& model);

} // namespace orograph
