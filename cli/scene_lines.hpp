// SPDX-License-Identifier: GPL-3.0-or-later
// Which lines a scene has beside its profiles, and which of the visible ones are worth drawing.
#pragma once

#include "cli/line_sweep.hpp"
#include "cli/scene.hpp"
#include "profiles/seen_ground.hpp"

#include <string_view>
#include <vector>

namespace orograph {

bool asks_for(const RenderSettings& settings, std::string_view layer);

/// All lines that hide or are drawn: silhouettes, the border and that of voids, shores. Silhouettes
/// only of `ground`, where that isn't all.
std::vector<SweptLine> lines_of(const Terrain& terrain, const Scene& scene,
                                const RenderSettings& settings, const SeenGround* ground = nullptr);

/// The parts of silhouettes behind which the ground comes up again within a share of the depth
/// (`--silhouette-jump`): folds of a slope, not ridges. In a parallel view, which has no eye to be
/// far from, the share is of the terrain's own extent in depth, `parallel_depth_m`.
std::vector<LinePart> folds(const LineSweep& sweep, const std::vector<LinePart>& parts,
                            const Surface& surface, const View& view, double share,
                            double parallel_depth_m);

} // namespace orograph
