// SPDX-License-Identifier: GPL-3.0-or-later
// Where a grid has ground: the vertices of its outline, and whether a larger triangle has any.
#pragma once

#include "dem/approximate/lattice_triangulation.hpp"
#include "dem/grid.hpp"

#include <cstddef>
#include <vector>

namespace orograph {

struct GridOutline {
  std::size_t triangles = 0; ///< of the whole grid
  /// Vertices where a triangle that is there meets one that isn't: row-major. Where the outline is
  /// the grid's own end, only those at which it leaves that.
  std::vector<LatticePoint> vertices;
};

GridOutline outline_of(const Grid& grid);

/// Whether there is ground next to corner `a` in a, b, c (twice_area > 0): in all of the triangle,
/// where no edge of the outline crosses it. REQUIRES a triangle within the grid.
bool has_ground(const Grid& grid, LatticePoint a, LatticePoint b, LatticePoint c);

} // namespace orograph
