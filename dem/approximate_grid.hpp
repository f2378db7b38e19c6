// SPDX-License-Identifier: GPL-3.0-or-later
// A Tin of few triangles that stays close to a grid.
#pragma once

#include "dem/grid.hpp"
#include "dem/tin.hpp"

namespace orograph {

struct ApproximatedGrid {
  Tin tin;
  double greatest_at_vertices_m = 0; ///< vertical distance at the grid's vertices; within the bound
  /// Vertical distance between the two surfaces anywhere: greatest at the grid's vertices or where
  /// edges of the two cross.
  double greatest_m = 0;
};

/// The Tin of the grid's own triangles: the same surface. Vertices keep their order; those without
/// a triangle are left out.
Tin tin_of(const Grid& grid);

/// Vertices of the grid are added to a Delaunay triangulation, always the one farthest from its
/// triangle (Garland and Heckbert 1995, greedy insertion), until none is farther than
/// `max_error_m`. The outline of what is there, holes included, stays as it is. REQUIRES
/// max_error_m >= 0. Throws Error where the grid has no triangle. Cost O(n log n) for n vertices of
/// the grid, or so.
ApproximatedGrid approximate(const Grid& grid, double max_error_m);

} // namespace orograph
