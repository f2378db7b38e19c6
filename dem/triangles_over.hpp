// SPDX-License-Identifier: GPL-3.0-or-later
// The ground about some places.
#pragma once

#include "dem/extent.hpp"
#include "dem/surface.hpp"
#include "geometry/box.hpp"

#include <array>
#include <span>
#include <vector>

namespace orograph {

/// Corners in the ground frame, true heights, counterclockwise seen from above.
using GroundTriangle = std::array<Vec3, 3>;

/// For each box of ground the triangles that meet it seen from above, and perhaps others near it;
/// in the surface's order. Walls, and what the ellipsoid turns over, are left out. REQUIRES that
/// `extent` is the surface's. Cost: of a grid, the cells in the boxes; of a TIN, an index of all
/// its triangles.
std::vector<std::vector<GroundTriangle>>
triangles_over(const Surface& surface, const SurfaceExtent& extent, std::span<const Box2> boxes);

} // namespace orograph
