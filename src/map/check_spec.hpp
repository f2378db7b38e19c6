// SPDX-License-Identifier: GPL-3.0-or-later
// What of a MapSpec makes no sense, whatever the terrain.
#pragma once

#include "geometry/vec.hpp"
#include "placing/map_spec.hpp"

#include <vector>

namespace orograph {

/// Throws Error with ErrorCode::request, which names the field, where a number is out of its range
/// or none, where a layer isn't in the table or there twice, and where two wishes exclude each
/// other: an eye, a distance or a field in a parallel view; solids where only profiles hide.
void check_spec(const MapSpec& spec, bool has_solids);

/// Of the underside: a view from below shows nothing else, and not everything goes with it. Throws
/// UsageError.
void check_underside(const MapSpec& spec);

/// Sizes, and whether each piece has a meaning in this view. Throws UsageError.
void check_furniture(const MapSpec& spec);

/// The same of an eye that looks around: it has to be there.
void check_eye_spec(const ViewSpec& view);
/// The same of places, which are finite, and their height above the ground, from 0 on.
void check_sights(const std::vector<Vec2>& places, double above_m);
/// The same of degrees from a direction of the skyline to the next, 0.001 to 90.
void check_skyline_step(double step_deg);

} // namespace orograph
