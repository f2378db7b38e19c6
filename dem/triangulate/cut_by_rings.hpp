// SPDX-License-Identifier: GPL-3.0-or-later
// Rings without heights cut a surface as scissors do.
#pragma once

#include "dem/triangulate/plane_triangulation.hpp"
#include "dem/triangulate/triangulate.hpp"

#include <cstdint>
#include <vector>

namespace orograph {

/// Puts the rings that have no heights into the triangulation so that each of their edges runs
/// along its edges, and the surface stays as it is: triangles that a ring meets are only split.
/// Vertices beyond the hull of what was there have no height (NaN) afterwards; all others have one.
/// `heights_m` holds one for each vertex and grows with them. Returns the rings' lines.
std::vector<std::uint32_t> cut_by_rings(PlaneTriangulation& plane,
                                        const std::vector<BoundaryRing>& rings,
                                        const std::vector<std::uint32_t>& breaklines,
                                        std::vector<double>& heights_m);

} // namespace orograph
