// SPDX-License-Identifier: GPL-3.0-or-later
// Visible parts of lines on the ground, as strokes that know what they are lines of.
#pragma once

#include "draw/drawing.hpp"
#include "draw/stroke_builder.hpp"
#include "hidden_lines/ground_lines.hpp"
#include "hidden_lines/line_parts.hpp"

#include <cstddef>
#include <vector>

namespace orograph {

/// Draws parts, by line, of a view's `lines`, from number `first_line` on those of `on_ground`;
/// feature by feature, so that no stroke is of two. `layer` gets strokes and features. Returns the
/// length of what was too short, in mm. On all cores, with the same strokes on any number of them.
double draw_features(const Surface& surface, const View& view, const std::vector<EdgeLine>& lines,
                     const GroundLines& on_ground, std::size_t first_line,
                     std::vector<LinePart> parts, const StrokeSettings& settings,
                     const StrokeSettings& of_ticks, Layer& layer);

} // namespace orograph
