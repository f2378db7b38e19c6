// SPDX-License-Identifier: GPL-3.0-or-later
// Contours as strokes that know their heights.
#pragma once

#include "draw/drawing.hpp"
#include "draw/stroke_builder.hpp"
#include "hidden_lines/contour_chains.hpp"
#include "hidden_lines/ground_lines.hpp"
#include "hidden_lines/line_parts.hpp"
#include "view/view.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace orograph {

/// Of the ground, not of a wall.
inline bool is_contour(LineKind kind) {
  return kind == LineKind::contour || kind == LineKind::index_contour;
}

/// Takes them out of parts, by line, of contours that were listed and of their ticks, which stay:
/// of a view's `lines`, from number `first_line` on those of `on_ground`, of which `whole` marks
/// those that are seen from end to end and aren't among the parts: ticks then are.
SeenContours take_contours(const Surface& surface, const View& view,
                           const std::vector<EdgeLine>& lines, const GroundLines& on_ground,
                           std::size_t first_line, std::span<const std::uint8_t> whole,
                           std::vector<LinePart>& parts);

/// Draws those whose feature is of a kind, level by level. `layer` gets strokes and features.
/// Returns the length of what was too short, in mm. On all cores, with the same strokes on any
/// number of them, and in whatever order they were found.
double draw_contours(const View& view, const SeenContours& contours, const GroundLines& on_ground,
                     LineKind kind, const StrokeSettings& settings, Layer& layer);

} // namespace orograph
