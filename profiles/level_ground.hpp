// SPDX-License-Identifier: GPL-3.0-or-later
// Seas and lakes: connected triangles of exactly one height.
#pragma once

#include "dem/surface.hpp"
#include "profiles/outline.hpp"
#include "profiles/triangles.hpp"

#include <span>
#include <vector>

namespace orograph {

struct LevelGround {
  TriangleSet triangles;           ///< empty where there is no level ground
  std::vector<SurfaceEdge> shores; ///< edges between level ground and other terrain, in order
  std::size_t regions = 0;
};

/// The level regions of at least `smallest` triangles. Two triangles belong together if they share
/// an edge. Cost: one pass over the heights; memory a bit a triangle and 12 bytes for each run of
/// level triangles along a row.
LevelGround find_level_ground(const Grid& grid, std::size_t smallest);
/// The level regions of at least `smallest_m2`, seen from above. Cost: one pass.
LevelGround find_level_ground(const Tin& tin, double smallest_m2);
/// The same by other heights of its vertices than those in the ground frame, as of one that lies on
/// the ellipsoid.
LevelGround find_level_ground(const Tin& tin, std::span<const double> heights_m,
                              double smallest_m2);

/// Level ground of the size from which it reads as water on a page rather than as a step of
/// whole-metre heights. Of a grid: 500 triangles, and a five-thousandth of it (10 mm² of an A4
/// map). Of a TIN, where triangles on a contour line's inner bends are level too: a thousandth of
/// its ground.
LevelGround find_water(const Grid& grid);
LevelGround find_water(const Tin& tin);
/// Triangles that the smallest water of a grid has.
std::size_t least_of_water(const Grid& grid);

/// For each edge of the border whether its one triangle is of a set. `border` is `border_edges` of
/// the surface. Cost: that of the border; of a TIN one pass over its triangles.
std::vector<bool> borders_of(const Surface& surface, const std::vector<BorderEdge>& border,
                             const TriangleSet& triangles);

} // namespace orograph
