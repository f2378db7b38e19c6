// SPDX-License-Identifier: GPL-3.0-or-later
// The direction of vertical triangles.
#pragma once

#include "dem/tin.hpp"

namespace orograph {

/// Turns walls so that they run along edges the other way than their neighbours do; from walls
/// that stand beside triangles which aren't vertical the direction spreads to the walls beside
/// them. Where neighbours ask for different things one of them is followed; where no neighbour asks
/// for any, the wall of lowest number stays as it is. REQUIRES the right neighbours, which are kept
/// so.
void turn_walls(Tin& tin);

/// Turns a triangle over: its second and third vertices change places, as do its neighbours there.
void turn_over(Tin& tin, std::uint32_t triangle);

} // namespace orograph
