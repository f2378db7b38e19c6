// SPDX-License-Identifier: GPL-3.0-or-later
// Ridges' lines as light and distance have them: heavier on the side in shadow, thinner far away.
#pragma once

#include "draw/drawing.hpp"

#include <cmath>
#include <optional>

namespace orograph {

/// Light from one direction all over a panorama, which it meets at another angle everywhere.
struct StandingLight {
  Vec3 towards;                ///< right, away from the viewer, up; at `middle_mm`
  double middle_mm, radius_mm; ///< x on the page, and how wide a radian is

  /// On the page, unit.
  Vec2 on_page(double x_mm) const {
    const double turn = (x_mm - middle_mm) / radius_mm;
    const Vec2 way{towards.x * std::cos(turn) - towards.y * std::sin(turn), -towards.z};
    const double size = plain_length(way);
    return size > 0 ? (1 / size) * way : Vec2{0, -1};
  }
};

/// Which way light falls on a picture's outlines, and how they fade with depth.
struct LineShade {
  Vec2 up;            ///< on the page, y down: where heights rise; unit
  Vec2 towards_light; ///< on the page; unit
  std::optional<StandingLight> standing = std::nullopt; ///< instead of it
  double contrast = 1;                  ///< 0: all outlines are as heavy as level ones
  double haze = 0;                      ///< share of their width that lines at `farthest_m` lose
  double nearest_m = 0, farthest_m = 0; ///< depths; at the first nothing is lost
};

/// The layer with its strokes as wide as they are to be, one after another where they differ. A
/// line that bounds terrain from above, as ridges do, is level_width (1 + c/2 (l - n . t)) wide: n
/// is its normal on the upper side, averaged over a millimetre and a half, t the direction to the
/// light, l what n . t is of a level line, c the contrast; between half and twice the layer's pen;
/// less by haze. Widths come in steps of a tenth and keep for a millimetre at least. REQUIRES a
/// layer with depths; they are gone then.
Layer shaded(const Layer& layer, const LineShade& shade);

} // namespace orograph
