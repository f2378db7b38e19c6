// SPDX-License-Identifier: GPL-3.0-or-later
// What is seen of the edges of solids, and drawing it.
#pragma once

#include "cli/line_parts.hpp"
#include "cli/solids/ground_shadows.hpp"
#include "draw/stroke_builder.hpp"
#include "solids/solids_in_view.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace orograph {

/// The edges of all solids, numbered through.
struct SolidLine {
  std::uint32_t solid, edge;
};
std::vector<SolidLine> lines_of(std::span<const StandingSolid> standing);

/// Parts of `lines_of` the solids, by line; along the edge, 0 at `from` and 1 at `to`.
struct SolidParts {
  std::vector<LinePart> visible;
  std::vector<LinePart> hidden; ///< in front of the near plane, and not visible
};

/// `ground`: what it hides of each solid. Faces that are turned away are culled first (Chen and
/// Sabbagh 1983, section 5.8), so an edge between two of them is hidden as a whole, and one between
/// a light and a dark face is there once.
SolidParts seen_edges(const SolidsInView& solids, const std::vector<GroundShadows>& ground);

/// Leaves out of `parts` what is drawn already: parts whose two ends are those of an earlier one,
/// or of any of `drawn`, on the page's step. Where solids touch, an edge may be one of several.
void drop_repeated(std::span<const StandingSolid> standing, const View& view,
                   const Homography& to_page, const std::vector<LinePart>& drawn,
                   std::vector<LinePart>& parts);

/// Draws parts of edges as long strokes, joined where they meet at a vertex of their solid.
void draw_edges(std::span<const StandingSolid> standing, const View& view,
                const std::vector<LinePart>& parts, StrokeBuilder& builder);

} // namespace orograph
