// SPDX-License-Identifier: GPL-3.0-or-later
// What is seen of the edges of solids.
#pragma once

#include "solids/solids_in_view.hpp"

#include <vector>

#include "hidden_lines/ground_shadows.hpp"
#include "hidden_lines/line_parts.hpp"

namespace orograph {

/// Parts of the edges of all solids, numbered through, by number; along the edge, 0 at `from` and 1
/// at `to`.
struct SolidParts {
  std::vector<LinePart> visible;
  std::vector<LinePart> hidden; ///< in front of the near plane, and not visible
};

/// `ground`: what it hides of each solid. Faces that are turned away are culled first (Chen and
/// Sabbagh 1983, section 5.8), so an edge between two of them is hidden as a whole, and one between
/// a light and a dark face is there once.
SolidParts seen_edges(const SolidsInView& solids, const std::vector<GroundShadows>& ground);

} // namespace orograph
