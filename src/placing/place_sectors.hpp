// SPDX-License-Identifier: GPL-3.0-or-later
// The sectors of a placed view: which depths they have, and which profiles.
#pragma once

#include "dem/surface.hpp"
#include "placing/placed_view.hpp"

namespace orograph {

/// Finds the depths between which there is ground, in each of a panorama's sectors too, which it
/// places without profiles. REQUIRES a view and a page that are placed, and that there is ground.
void find_depths(PlacedView& placed, const Surface& surface);

/// Gives the profiles at `depths_m` to the sectors, and places those of a plane picture: the sides
/// of the eye on which there is something.
void place_sectors(PlacedView& placed);

} // namespace orograph
