// SPDX-License-Identifier: GPL-3.0-or-later
// Where the terrain ends against what is behind it (docs/how-it-works.md).
#pragma once

#include "dem/grid.hpp"
#include "profiles/triangles.hpp"
#include "view/view.hpp"

#include <vector>

namespace orograph {

/// The edges between a triangle that the eye sees, on the nearer side, and one turned away from it,
/// on the farther side; row by row. Facing is the sign of N . (E - P); zero counts as turned away.
/// Where a sign is within its rounding bound, and where the eye can't be told to be on one side of
/// an edge's line, both cases are taken as possible, so that no silhouette is missed: an edge more
/// hides nothing that isn't hidden.
/// Cost: one pass over the heights, a few flops a triangle.
std::vector<GridEdge> silhouette_edges(const Grid& grid, const View& view);

} // namespace orograph
