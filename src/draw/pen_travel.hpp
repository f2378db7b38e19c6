// SPDX-License-Identifier: GPL-3.0-or-later
// How far a plotter's pen goes to draw a drawing.
#pragma once

#include "draw/drawing.hpp"

namespace orograph {

struct PenTravel {
  double down_mm = 0; ///< the strokes' length
  double up_mm = 0;   ///< between strokes
};

/// Strokes in drawing order, each from its first point. The pen starts above the page's upper left
/// corner, as plotters do, and its way back after the last stroke isn't counted.
PenTravel pen_travel(const Drawing& drawing);

} // namespace orograph
