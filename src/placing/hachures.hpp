// SPDX-License-Identifier: GPL-3.0-or-later
// Where hachures lie: lines down the slope, about as far apart on the page everywhere.
#pragma once

#include "dem/surface.hpp"
#include "geometry/vec.hpp"
#include "placing/map_spec.hpp"
#include "placing/placed_view.hpp"

#include <vector>

namespace orograph {

/// A part of a hachure that has one width. Parts of one hachure follow each other, and touch.
struct HachureRun {
  std::vector<Vec2> places; ///< u and v, in the profile frame of the view; down the slope
  double slope_deg;         ///< mean, of the smoothed ground as it is, not exaggerated
  double width_mm;
};

/// Hachures are heavier on steeper slopes, as Lehmann has them (Darstellung einer neuen Theorie
/// der Bezeichnung der schiefen Flächen, 1799): from half the pen to half the spacing, linear in
/// the slope's angle.
double hachure_width_mm(const HachureSpec& spec, double pen_width_mm, double slope_deg);

/// Of the ground that is turned to the eye and in the page's frame; what stands in front of it is
/// no matter. A line goes down the slope of the ground, smoothed over about 1.5 mm of the
/// page, and begins in the middle of a gap of more than 1.4 spacings; it ends where it comes as
/// close as 0.65 of one to another, where the slope is less than asked for, and where the ground
/// ends or turns away. None is shorter than 3 spacings.
/// Cost: some microseconds a millimetre of line, beside the smoothed ground.
std::vector<HachureRun> hachures(const Surface& surface, const PlacedView& placed,
                                 const HachureSpec& spec, double pen_width_mm);

} // namespace orograph
