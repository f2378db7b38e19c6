// SPDX-License-Identifier: GPL-3.0-or-later
// A view of plane projection by the parameters that PHIGS gives it (ISO 9592-1), as plain values;
// and what it is to the cut and the clip: its profiles, its visibility plane, its View
// (docs/how-it-works.md).
#pragma once

#include "geometry/box.hpp"
#include "geometry/homography.hpp"
#include "geometry/vec.hpp"
#include "view/projection.hpp"
#include "view/view.hpp"

#include <array>

namespace orograph {

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

/// The eye in the world: VRP + p_u u + p_v v + p_n n. REQUIRES a perspective view; throws the
/// Errors of view_orientation.
Vec3 eye_m(const PhigsView& view);

/// Direction of projection in the world, a unit vector that points away from the viewer: from the
/// PRP to the window's centre. (In a perspective view that is the ray to the picture's centre.)
/// Throws the Errors of view_orientation and of view_mapping.
Vec3 direction_of_projection(const PhigsView& view);

/// The frame of profiles: a point P has u = (P - origin).R, v = (P - origin).F (its depth) and z,
/// with R = F x up.
struct ProfileFrame {
  Vec3 origin_m;      ///< the eye; in a parallel projection below the VRP at height 0
  Vec2 forward{0, 1}; ///< F, unit
  Vec2 right() const { return {forward.y, 0 - forward.x}; }
};

/// Straight down or up, to rounding. REQUIRES a unit vector.
inline bool is_vertical(Vec3 direction) {
  return std::hypot(direction.x, direction.y) <= 1e-12;
}

/// Profiles parallel to the view plane: F is the horizontal part of -n. Where the view plane is
/// level, F is the plate's up direction in perspective. In a parallel projection, where the plane
/// is level or depth along F would hardly grow (by less than a thousandth) along the direction of
/// projection, F is the horizontal part of that direction, and the plate's up direction only where
/// that is vertical. Throws the same Errors.
ProfileFrame frame_of(const PhigsView& view);

/// The picture of the visibility plane's point (X, Y) in page mm. For a point (u, v, z) of the
/// frame, with z the height above the frame's origin,
/// - perspective: X = u / v, Y = z / v, for v > 0;
/// - parallel along (d_u, d_v, d_z), d_v > 0: X = u - v d_u / d_v, Y = z - v d_z / d_v;
/// - parallel along the vertical: X = u, Y = v.
/// Derivation: with M the 4x4 matrix of the pipeline, the image of the eye has x = y = w = 0, so M
/// takes the point eye + v (X R + F + Y up) to v M (X R + Y up + F, 0): the columns are those of
/// R, up and F under M's rows x, y and w. In a parallel view M takes d to x = y = w = 0, so that
/// what counts of a point is origin + X R + Y up: the columns are R, up and the origin's point.
/// REQUIRES, in a perspective view, the frame's origin at the eye, any F; in a parallel one a frame
/// with d_v > 0, or the direction vertical. Throws the Errors of `compose`.
Homography homography_of(const PhigsView& view, const ProfileFrame& frame, const Box2& viewport_mm);

/// Where in the view volume's depth a point (u, v, z) of the frame is, z here above height 0: the
/// factors of u, v, z and 1 in its z of the canonical parallel volume, times the w that the
/// homography gives it; so between -w at the back plane and 0 at the front plane.
std::array<double, 4> volume_depth(const PhigsView& view, const ProfileFrame& frame);

/// The view with its profiles parallel to the view plane (`frame_of`), its picture plane the view
/// plane in metres, its window the same. `exaggeration` is what heights in `phigs` are multiplied
/// by already; `cell_m` is the terrain's finest ground detail. Front and back plane are not looked
/// at: they cut the terrain (dem/mesh).
/// Throws the Errors of the pipeline, and one for a parallel view that looks up.
View place_phigs_view(const PhigsView& phigs, double exaggeration, double cell_m,
                      const EarthDrop& drop = {});

/// The same the other way round, for every kind of view: a PHIGS view with the same picture, its
/// view plane at distance 1 from the eye, or through the depth origin at height 0 in a parallel
/// view. Of front and back plane it keeps the defaults. REQUIRES that it wasn't placed from a PHIGS
/// view.
PhigsView phigs_of(const View& view);

} // namespace orograph
