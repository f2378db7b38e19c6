// SPDX-License-Identifier: GPL-3.0-or-later
// Contours that the pass has found, as strokes that know their heights.
#pragma once

#include "draw/drawing.hpp"
#include "draw/stroke_builder.hpp"
#include "hidden_lines/contour_chains.hpp"
#include "hidden_lines/ground_lines.hpp"
#include "view/view.hpp"

namespace orograph {

/// Draws those whose feature is of a kind, level by level. `layer` gets strokes and features.
/// Returns the length of what was too short, in mm. On all cores, with the same strokes on any
/// number of them, and in whatever order they were found.
double draw_contours(const View& view, const SeenContours& contours, const GroundLines& on_ground,
                     LineKind kind, const StrokeSettings& settings, Layer& layer);

} // namespace orograph
