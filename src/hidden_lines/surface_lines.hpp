// SPDX-License-Identifier: GPL-3.0-or-later
// Which lines are taken beside the profiles.
#pragma once

#include "hidden_lines/line_pictures.hpp"
#include "placing/placed_view.hpp"
#include "profiles/seen_ground.hpp"
#include "profiles/sheet.hpp"

#include <vector>

namespace orograph {

/// Lines that hide or are drawn but silhouettes: the border and that of voids, shores, edges. An
/// edge of several kinds is drawn as the first; those that are silhouettes, too, are still there.
std::vector<EdgeLine> lines_but_silhouettes(const TerrainData& terrain, const PlacedView& placed,
                                            const Style& style);
/// All lines that hide or are drawn: first silhouettes, only of `ground`, where that isn't all.
std::vector<EdgeLine> lines_of(const TerrainData& terrain, const PlacedView& placed,
                               const Style& style, const SeenGround* ground = nullptr);
/// The same of a sheet, with the edges where its underside ends as well.
std::vector<EdgeLine> lines_of_sheet(const TerrainData& terrain, const PlacedView& placed,
                                     const Style& style, const Sheet& sheet);

/// Whether border that is the horizon is drawn as skyline. In a plan (straight from above, in
/// parallel, or with rays beside the eye) it isn't: there the eye sees all of the border alike.
bool outlines_terrain(const Style& style, const View& view);

/// Whether silhouettes are drawn.
bool draws_silhouettes(const Style& style);

} // namespace orograph
