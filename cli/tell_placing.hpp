// SPDX-License-Identifier: GPL-3.0-or-later
// What `render` says on stderr of how a map was placed.
#pragma once

#include "placing/map_spec.hpp"
#include "placing/placed_view.hpp"

namespace orograph {

/// A line for each thing that was chosen for the user, and for what may be wrong with the eye, each
/// with the option that says otherwise.
void tell_placing(const PlacedView& placed, const ViewSpec& view);

} // namespace orograph
