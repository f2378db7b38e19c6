// SPDX-License-Identifier: GPL-3.0-or-later
// Which lines are taken beside the profiles, and which of the visible ones are worth drawing.
#pragma once

#include "hidden_lines/line_pictures.hpp"
#include "placing/placed_view.hpp"
#include "profiles/seen_ground.hpp"

#include <vector>

namespace orograph {

/// All lines that hide or are drawn: silhouettes, the border and that of voids, shores. Silhouettes
/// only of `ground`, where that isn't all.
std::vector<EdgeLine> lines_of(const TerrainData& terrain, const PlacedView& placed,
                               const Style& style, const SeenGround* ground = nullptr);

/// The parts of silhouettes behind which the ground comes up again within a share of the depth
/// (`Style::silhouette_jump`): folds of a slope, not ridges. In a parallel view, which has no eye
/// to be far from, the share is of the terrain's own extent in depth, `parallel_depth_m`.
std::vector<LinePart> folds(const LinePictures& lines, const std::vector<LinePart>& parts,
                            const Surface& surface, double share, double parallel_depth_m);

} // namespace orograph
