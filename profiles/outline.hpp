// SPDX-License-Identifier: GPL-3.0-or-later
// Where the terrain begins and ends, and which part of that border lies around voids: ground
// without heights that terrain encloses.
#pragma once

#include "dem/surface.hpp"
#include "profiles/triangles.hpp"
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

/// For each edge of the border whether it is of a void's outline. Walked with the terrain on its
/// left, the border is closed loops; one that runs clockwise, seen from above, lies around a void,
/// one that runs counterclockwise is the outer border of terrain, of an island in a void as well.
/// Where several loops meet in a vertex each goes on round the ground that it came along, so that
/// missing ground is one void as far as it is connected through edges. (Where walls of a TIN begin
/// or end in such a vertex as well, the view from above may not tell which way to go on; loops are
/// closed there too.) A loop without extent, seen from above, is no void's.
///
/// `border` is `border_edges` of the surface. Cost O(n log n) for n edges of the border.
std::vector<bool> around_voids(const Grid& grid, const std::vector<BorderEdge>& border);
std::vector<bool> around_voids(const Tin& tin, const std::vector<BorderEdge>& border);
std::vector<bool> around_voids(const Surface& surface, const std::vector<BorderEdge>& border);

} // namespace orograph
