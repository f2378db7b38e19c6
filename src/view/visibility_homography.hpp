// SPDX-License-Identifier: GPL-3.0-or-later
// From the visibility plane of a view of plane projection to the page (docs/how-it-works.md).
#pragma once

#include "geometry/homography.hpp"
#include "view/phigs_view.hpp"
#include "view/profile_frame.hpp"

#include <array>

namespace orograph {

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

} // namespace orograph
