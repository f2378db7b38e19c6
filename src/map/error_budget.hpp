// SPDX-License-Identifier: GPL-3.0-or-later
// How far a drawn line can be from where it should be, by cause (docs/how-it-works.md).
#pragma once

#include "map/map_facts.hpp"
#include "placing/map_spec.hpp"
#include "placing/placed_view.hpp"

namespace orograph {

/// Each cause's bound in mm on paper; the rounding is that of the page's step.
ErrorBudget error_budget(const TerrainData& terrain, const PlacedView& placed, const MapSpec& spec);

} // namespace orograph
