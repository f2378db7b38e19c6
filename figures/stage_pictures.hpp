// SPDX-License-Identifier: GPL-3.0-or-later
// The house and its view volume after each stage of the view pipeline, as pictures.
#pragma once

#include "figures/line_picture.hpp"
#include "view/pipeline.hpp"

namespace orograph {

/// A view with what its stages are.
struct Stages {
  PhigsView view;
  CanonicalVolume volume;
  Eigen::Matrix4d orientation; ///< world to (u, v, n)
  Eigen::Matrix4d mapping;     ///< (u, v, n) to the canonical volume
  Eigen::Matrix4d to_parallel; ///< that one to the canonical volume of parallel projection
};

/// Throws the stages' Errors.
Stages stages_of(const PhigsView& view);

// In each picture, what the view volume holds of the house is heavy; what it doesn't hold is faint,
// and so is what the house itself hides. The house's section with the back plane is drawn too.

/// In the world, with window, axes u, v, n, and PRP. `aside` is how somebody sees the world from
/// aside, as a matrix to a picture plane (x, y) that z stands up from, to the viewer.
LinePicture world_picture(const Stages& stages, const Eigen::Matrix4d& aside);

/// In the view's canonical volume, from aside, with its axes x, y, z.
LinePicture canonical_picture(const Stages& stages);

/// In the canonical volume of parallel projection, alike.
LinePicture straight_picture(const Stages& stages);

/// What the window shows, and its frame, in the window's proportions.
LinePicture page_picture(const Stages& stages);

} // namespace orograph
