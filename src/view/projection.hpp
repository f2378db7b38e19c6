// SPDX-License-Identifier: GPL-3.0-or-later
// The kinds of projection that a view may have.
#pragma once

#include "geometry/angle.hpp"

namespace orograph {

/// Where the ground is level that a framed view's elevation is above. On ground that sinks with the
/// earth the target's horizontal slopes towards the eye.
enum class Horizontal { of_target, of_eye };

/// The last two are panoramas: no plane pictures, but of all that is about an eye.
enum class Projection { perspective, orthographic, oblique, cylindrical, equirectangular };

constexpr bool is_panorama(Projection projection) {
  return projection == Projection::cylindrical || projection == Projection::equirectangular;
}

/// Of a view by its PHIGS parameters, which don't tell parallel kinds apart.
enum class PhigsProjection { perspective, parallel };

/// A parallel view onto an upright plate: what lies across the view keeps its true shape, and a
/// line straight away from the viewer is drawn `length` times as long as it is, at an angle `rise`
/// above the horizontal, to the right.
struct Oblique {
  double length = 1;
  Angle rise = Angle::degrees(45);
};
/// Lines away from the viewer as long as they are, at 45 degrees.
constexpr Oblique kCavalier{1, Angle::degrees(45)};
/// Half as long.
constexpr Oblique kCabinet{0.5, Angle::degrees(45)};
/// Straight up: the plan is true, and heights are drawn upwards from it.
constexpr Oblique kMilitary{1, Angle::degrees(90)};

} // namespace orograph
