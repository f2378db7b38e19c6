// SPDX-License-Identifier: GPL-3.0-or-later
// Where a surface's heights are, by blocks.
#pragma once

#include "dem/grid.hpp"
#include "dem/surface.hpp"
#include "geometry/blocked_points.hpp"

namespace orograph {

/// What one pass over the heights tells.
struct SurfaceExtent {
  BlockedPoints
      blocks; ///< valid vertices (ground position and height, metres); refers to the surface
  Box3 box;   ///< of all valid vertices
  double mean_height_m = 0;    ///< of all valid vertices; of a TIN, of its ground
  std::size_t valid = 0;       ///< vertices that have a height
  std::size_t turned_over = 0; ///< triangles that the ellipsoid turns over in plan: cliffs far
                               ///< away, which lean beyond upright
};

/// REQUIRES at least one valid vertex. One pass, at the speed of memory; on the ellipsoid some
/// nanoseconds a vertex. Blocks are 32 x 32 vertices, some 1.2 % of the heights' memory.
SurfaceExtent extent_of(const Grid& grid);
/// REQUIRES a triangle. The mean height is that of the ground, each triangle counting by its area
/// seen from above. Blocks are 1024 vertices on end, which lie close together if the TIN's order is
/// spatial.
SurfaceExtent extent_of(const Tin& tin);
SurfaceExtent extent_of(const Surface& surface);

/// From the vertex in a grid's middle, at height 0, to the next along its row and its column: the
/// steps everywhere on a map plane, those of the middle on the ellipsoid.
struct GridSteps {
  Vec2 column_m, row_m;
};
GridSteps steps_of(const Grid& grid);

/// The finest ground detail that a surface holds, in metres: a grid's smaller step; for a TIN the
/// step of a square grid with as many triangles on as much ground.
double cell_size_m(const Grid& grid);
double cell_size_m(const Tin& tin);
double cell_size_m(const Surface& surface);

/// Bound on how far vertices are from the ground frame's origin, in metres on the ground.
double reach_m(const Surface& surface);

/// The range of a grid's true heights, wherever its vertices lie.
struct HeightRange {
  double low_m, high_m, mean_m;
};

/// REQUIRES a vertex with a height. One pass, at the speed of memory.
HeightRange height_range(const Grid& grid);

} // namespace orograph
