// SPDX-License-Identifier: GPL-3.0-or-later
// Profiles even on the page, with light on them, of a view that has its place.
#pragma once

#include "placing/map_spec.hpp"
#include "placing/placed_view.hpp"

namespace orograph {

/// Puts profiles where lines are to be, with their runs, where `spec` wants that: lines that are
/// even on the page are those of a spacing in millimetres, light is on any. Lines that
/// keep their places on the ground are told how dark it is, and keep one pen. Profiles that hide
/// stay as they are.
void give_tone(PlacedView& placed, const Surface& surface, const MapSpec& spec);

/// How light and haze show on ridges; none where they don't, since there is no light, or one that
/// doesn't show in widths, or lines keep their places on the ground.
std::optional<LineShade> ridge_shade(const PlacedView& placed, const MapSpec& spec);

} // namespace orograph
