// SPDX-License-Identifier: GPL-3.0-or-later
// A Tin of few triangles that stays close to a grid.
#pragma once

#include "dem/approximate/tin_of_grid.hpp"
#include "dem/grid.hpp"
#include "dem/tin.hpp"

namespace orograph {

struct ApproximatedGrid {
  Tin tin;
  double greatest_at_vertices_m = 0; ///< vertical distance at the grid's vertices
  double greatest_m = 0;             ///< vertical distance between the surfaces anywhere
};

/// Vertices of the grid are added to a Delaunay triangulation, always where it is farthest from the
/// grid in height (greedy insertion: Garland and Heckbert 1995), until it is nowhere farther than
/// `max_error_m`. That is more than a bound at the grid's vertices, which alone would let an edge
/// of the Tin bridge a gully in the middle of a cell: where such an edge crosses one of the grid
/// too far above or below it, an end of the grid's edge is added. Both distances are measured on
/// the Tin once it is made.
///  (1) Delaunay by columns and rows, as if cells were square; the same triangles however the grid
///      lies on the ground.
///  (2) Vertices are the grid's: the same positions and heights to the last bit.
///  (3) The outline of what is there, holes included, stays as it is, with all its vertices; only
///      those on straight stretches of the grid's own end may be left out, within the bound.
///  (4) `max_error_m` = 0 gives tin_of(grid), the same drawing bit for bit, and both distances 0.
///      Any other bound may leave out vertices and turn diagonals where the grid is flat.
/// REQUIRES max_error_m >= 0 and what tin_of requires. Throws Error where the grid has no triangle.
/// Cost O(n log n) for n vertices of the grid, or so.
ApproximatedGrid approximate(const Grid& grid, double max_error_m);

} // namespace orograph
