// SPDX-License-Identifier: GPL-3.0-or-later
// Overlays that are too many for one pass, some millions of lines at a time.
#pragma once

#include "dem/terrain.hpp"
#include "draw/drawing.hpp"
#include "draw/stroke_builder.hpp"
#include "hidden_lines/instruments.hpp"
#include "hidden_lines/lines_of_view.hpp"
#include "hidden_lines/sector_pass.hpp"
#include "placing/map_spec.hpp"
#include "placing/placed_view.hpp"
#include "profiles/seen_ground.hpp"

#include <span>

namespace orograph {

/// Draws the overlays' features that the view's first pass has left, as it has drawn the others:
/// what is visible of them to `seen`, and if there is a layer for it, what is hidden to `hidden`;
/// both get strokes and features. `lines` are that pass's, and become those of the last one here;
/// `ground`: by sector, what is looked at, where that isn't all. Returns the length of visible
/// strokes that were too short, in mm. Memory: `Instruments::most_draped` lines.
double draw_more_overlays(const TerrainData& terrain, const PlacedView& placed, const Style& style,
                          std::span<const SeenGround> ground, const Instruments& instruments,
                          const StrokeSettings& settings, LinesOfView& lines, Layer& seen,
                          Layer* hidden, const PassCounts& counts);

/// How many of the features of lines on the ground are overlays', those that aren't on it, and
/// those that are in part.
void count_draped(const GroundLines& on_ground, Counts& counts);

} // namespace orograph
