// SPDX-License-Identifier: GPL-3.0-or-later
// What light leaves the ground along the lines of map formats, which tell it in a field.
#pragma once

#include "draw/drawing.hpp"
#include "placing/placed_view.hpp"

namespace orograph {

/// Gives the strokes of the profile layer their profile's level, and, where profiles know how dark
/// the ground is, the mean of that along each stroke. REQUIRES page points of `placed`.
void tell_darkness(Layer& profiles, const PlacedView& placed);

} // namespace orograph
