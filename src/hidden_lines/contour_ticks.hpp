// SPDX-License-Identifier: GPL-3.0-or-later
// Short ticks down the slope from contours around pits and depressions, as topographic maps have
// them: else a crater looks like a summit.
#pragma once

#include "dem/terrain.hpp"
#include "hidden_lines/ground_lines.hpp"
#include "placing/contours.hpp"
#include "placing/placed_view.hpp"

namespace orograph {

/// On the page, where it shows the ground unforeshortened; and from one to the next, as it shows
/// them.
constexpr double kTick_mm = 1, kTicksApart_mm = 3.5;

/// Adds ticks of all closed contours that have lower ground along their inside, at least four to
/// each that is in the frame as a whole, as features of their own with the contour's attributes. A
/// tick goes straight down from its contour as long as the ground falls; it ends well before the
/// next contour and the middle of what the contour encloses.
void add_contour_ticks(const TerrainData& terrain, const PlacedView& placed,
                       const ContourLevels& levels, GroundLines& out);

} // namespace orograph
