// SPDX-License-Identifier: GPL-3.0-or-later
// The view pipeline from a model to the page. Each stage is a 4x4 matrix that acts on columns
// (x, y, z, w): model_transform.hpp, view_orientation.hpp, view_mapping.hpp, and the last one here.
#pragma once

#include "view/phigs_view.hpp"

#include <Eigen/Core>

namespace orograph {

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
/// the viewport. Clipping to the view volume comes before the perspective transformation or after
/// it, clip_to_volume.hpp.
/// Throws the stages' Errors, and one if they overflow.
Eigen::Matrix4d compose(const Eigen::Matrix4d& model, const PhigsView& view,
                        const Box2& viewport_mm);

} // namespace orograph
