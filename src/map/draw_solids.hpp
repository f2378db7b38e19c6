// SPDX-License-Identifier: GPL-3.0-or-later
// From parts of solids' edges to strokes.
#pragma once

#include "draw/stroke_builder.hpp"
#include "hidden_lines/line_parts.hpp"
#include "placing/placed_view.hpp"
#include "solids/standing_solid.hpp"
#include "view/view.hpp"

#include <span>
#include <vector>

namespace orograph {

/// Leaves out of `parts` what is drawn already: parts whose two ends are those of an earlier one,
/// or of any of `drawn`, on the page's step. Where solids touch, an edge may be one of several.
void drop_repeated(const PlacedView& placed, const std::vector<LinePart>& drawn,
                   std::vector<LinePart>& parts);

/// Draws parts of edges, numbered as in SolidParts (hidden_lines/solid_lines.hpp), as long strokes,
/// joined where they meet at a vertex of their solid.
void draw_edges(std::span<const StandingSolid> standing, const View& view,
                const std::vector<LinePart>& parts, StrokeBuilder& builder);

} // namespace orograph
