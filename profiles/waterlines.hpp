// SPDX-License-Identifier: GPL-3.0-or-later
// Lines on level ground that follow its shores at given distances.
#pragma once

#include "dem/surface.hpp"
#include "profiles/level_ground.hpp"
#include "profiles/slab_lines.hpp"

#include <span>
#include <vector>

namespace orograph {

/// Straight lines on the ground, each within one triangle.
struct GroundLines {
  std::vector<EdgePoint> points;
  /// Numbers of their ends: the surface's count of vertices, and the place among `points`.
  std::vector<SurfaceEdge> lines;
};

/// Where the distance to the nearest shore is one of `distances_m`. It is exact at vertices of
/// level ground, along straight lines, and linear between them. Lines meet at edges of triangles in
/// one and the same point. REQUIRES rising distances above 0. Cost: O(log shores) for each vertex
/// of level ground; memory 8 bytes a vertex of the surface.
GroundLines waterlines(const Surface& surface, const LevelGround& level,
                       std::span<const double> distances_m);

} // namespace orograph
