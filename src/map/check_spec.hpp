// SPDX-License-Identifier: GPL-3.0-or-later
// What of a MapSpec makes no sense, whatever the terrain.
#pragma once

#include "placing/map_spec.hpp"

namespace orograph {

/// Throws Error with ErrorCode::request, which names the field, where a number is out of its range
/// or none, where a layer isn't in the table or there twice, and where two wishes exclude each
/// other: an eye, a distance or a field in a parallel view; solids where only profiles hide.
void check_spec(const MapSpec& spec, bool has_solids);

} // namespace orograph
