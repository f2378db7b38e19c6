// SPDX-License-Identifier: GPL-3.0-or-later
// The view pipeline from a model to the page, after PHIGS. Each stage is a 4x4 matrix that acts on
// columns (x, y, z, w), so in a product the rightmost acts first.
// Sources: Ian O. Angell and Brian J. Jones, Advanced graphics with the BBC model B microcomputer,
// 1983; Pee-Hong Chen and L. David Sabbagh, Technical Report 146, Indiana University, 1983;
// Alberto Paoluzzi, Geometric programming for computer-aided design, 2003: pipeline 3D, sections
// "parallel case", "perspective case" and 9.2.6, with its misprints put right.
#pragma once

#include "geometry/angle.hpp"
#include "geometry/vec.hpp"
#include "view/phigs_view.hpp"

#include <Eigen/Core>

#include <initializer_list>
#include <optional>

namespace orograph {

// Model transforms: from coordinates in which a thing is defined (SETUP) to the world's (ACTUAL).

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

// View orientation: from the world to view reference coordinates (u, v, n) of a PhigsView.

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

// View mapping: from view reference coordinates to a canonical volume; and from the canonical
// volume of perspective to that of parallel projection.

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

// Clipping an edge to a canonical volume, in homogeneous coordinates. It comes before the
// perspective transformation or after it.

/// The part of an edge within the volume: from + t (to - from) for t_begin <= t <= t_end, with its
/// two ends. It may be a single point.
struct AcceptedPart {
  double t_begin = 0, t_end = 1;
  Eigen::Vector4d begin, end;
};

/// Cohen and Sutherland's method with the six planes of the volume (geometry/clip_by_planes.hpp).
///
/// x, y and z are over w, and the sign of w counts: a point with w < 0 is behind the eye and
/// outside, and an edge between w > 0 and w < 0 is that of the scene, whose picture runs to
/// infinity. What is accepted has w > 0. A point on a plane is inside, and which side of a plane an
/// end is on is decided exactly: every plane's function is a sum of two terms, rounded once.
/// REQUIRES finite coordinates; no point from `from` to `to` is (0, 0, 0, 0), as none is that a
/// regular matrix made of a scene's edge.
std::optional<AcceptedPart> clip_to_volume(const Eigen::Vector4d& from, const Eigen::Vector4d& to,
                                           const CanonicalVolume& volume);

// From the canonical parallel volume to the page, and all of the way.

/// The square of the canonical parallel volume that holds the whole window of a view.
constexpr Box2 kWholeWindow{{-1, -1}, {1, 1}};

/// T(left, bottom, 0) S(width / w_width, -height / w_height, 1) T(-w_left, -w_bottom, 0): from the
/// canonical parallel volume to the page. The rectangle `window` of x and y fills `viewport_mm`;
/// z stays. On the page y runs down from the upper left corner, so `viewport_mm.low` is the
/// viewport's upper left; that alone makes the determinant negative, the picture isn't mirrored.
/// (Paoluzzi 2003, section 9.2.7.)
/// Throws Error: window or viewport empty or not finite.
Eigen::Matrix4d workstation_transformation(const Box2& window, const Box2& viewport_mm);

/// All stages, from a model's coordinates to the page: (x, y) of the image over its w is the place
/// in mm. w > 0 is in front of the eye; in a parallel projection w is 1. The view's window fills
/// the viewport.
/// Throws the stages' Errors, and one if they overflow.
Eigen::Matrix4d compose(const Eigen::Matrix4d& model, const PhigsView& view,
                        const Box2& viewport_mm);

} // namespace orograph
