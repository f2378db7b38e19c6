// SPDX-License-Identifier: GPL-3.0-or-later
// Where the terrain begins and ends.
#pragma once

#include "dem/surface.hpp"
#include "profiles/surface_edge.hpp"
#include "view/place_view.hpp"

#include <vector>

namespace orograph {

/// The edges that have a triangle on one side only: the data's border and the borders of voids, in
/// order. `left` tells that the triangle is to the left of from -> to, seen from above. Cost: one
/// pass over the triangles; over a grid without missing heights (`all_valid`) O(columns + rows).
struct BorderEdge {
  SurfaceEdge edge;
  bool left;
};
std::vector<BorderEdge> border_edges(const Grid& grid, bool all_valid);
std::vector<BorderEdge> border_edges(const Tin& tin);

/// The same as straight pieces on the ground, the terrain on their left.
std::vector<OutlineEdge> outline_of(const Grid& grid, const std::vector<BorderEdge>& border);
std::vector<OutlineEdge> outline_of(const Tin& tin, const std::vector<BorderEdge>& border);

} // namespace orograph
