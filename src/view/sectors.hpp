// SPDX-License-Identifier: GPL-3.0-or-later
// Views that show rays beside or behind the eye (docs/decisions/0010-sectors-and-planes.md).
#pragma once

#include "view/view.hpp"

#include <array>

namespace orograph {

/// What keeps to the plane between two sectors is taken to lie so many near planes ahead, in the
/// first sector; else neither would have it. Other lines are drawn from there on as well. The
/// ground before them is there but for a twentieth.
constexpr double kNearPlanesAhead = 20;

/// The ray of a point of the picture plane, from the eye, in the homogeneous coordinates of the
/// visibility plane: to_picture takes it to (x, y, 1), so in perspective its last coordinate, the
/// depth that it gains, is 0 beside the eye and less behind it.
Vec3 ray_of_picture(const View& view, Vec2 picture);

/// The rays of the window's corners: lower left, lower right, upper right, upper left. All that
/// the page shows is between them.
std::array<Vec3, 4> corner_rays(const View& view);

/// Whether the window holds rays that gain no depth, or hardly any (less than 0.05 of their
/// length): straight down or up, or aside. Always false in a parallel view.
bool shows_beside(const View& view);

/// Of a level view, how far its window may reach up and down at an abscissa without that; NaN where
/// the abscissa itself is beside the eye.
double greatest_y_ahead(double x);

/// v_near for a terrain with this finest ground detail: narrower where the page shows rays beside
/// the eye; 0 in a parallel view.
double near_plane_m(const View& view, double cell_m);

/// The homography of what is behind the eye, from that of what is ahead: to the same picture.
Homography homography_behind(const Homography& ahead);

/// The half of the world behind the eye of a perspective view: the same eye, looking the other way
/// round, so that what is behind it has positive depth; its `to_picture` leads to the same picture.
/// A point (u, v, z) of `view` is (-u, -v, z) there, to the bit.
View sector_behind(const View& view);

} // namespace orograph
