// SPDX-License-Identifier: GPL-3.0-or-later
// Where the terrain begins and ends.
#pragma once

#include "dem/grid.hpp"
#include "profiles/triangles.hpp"
#include "view/place_view.hpp"

#include <vector>

namespace orograph {

/// The edges that have a triangle on one side only: the data's border and the borders of holes, in
/// no particular order. `left` tells that the triangle is to the left of from -> to, seen from
/// above. Cost: one pass over the heights where some are missing (`all_valid` false), otherwise
/// O(columns + rows).
struct BorderEdge {
  GridEdge edge;
  bool left;
};
std::vector<BorderEdge> border_edges(const Grid& grid, bool all_valid);

/// The same as straight pieces on the ground, the terrain on their left.
std::vector<OutlineEdge> outline_of(const Grid& grid, const std::vector<BorderEdge>& border);

} // namespace orograph
