// SPDX-License-Identifier: GPL-3.0-or-later
// How far a drawn line can be from where it should be, by cause (docs/how-it-works.md).
#pragma once

#include "map/map_facts.hpp"
#include "placing/map_spec.hpp"
#include "placing/placed_view.hpp"

#include <optional>

namespace orograph {

/// Each cause's bound in mm on paper; the rounding is that of the page's step.
ErrorBudget error_budget(const TerrainData& terrain, const PlacedView& placed, const MapSpec& spec,
                         const std::optional<LevelOfDetail>& level);

/// How far, in mm on paper, points of the surface are from where those that it stands for would be
/// drawn: those of the file, whatever level of it is drawn. (Where two ridges nearly coincide in
/// the picture, what one hides of the other may change by more.)
double level_of_detail_mm(const TerrainData& terrain, const PlacedView& placed,
                          const std::optional<LevelOfDetail>& level);

} // namespace orograph
