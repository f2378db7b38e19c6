// SPDX-License-Identifier: GPL-3.0-or-later
// Where a view of plane projection has its eye, its direction and its profiles
// (docs/how-it-works.md).
#pragma once

#include "view/phigs_view.hpp"

namespace orograph {

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

} // namespace orograph
