// SPDX-License-Identifier: GPL-3.0-or-later
// Which triangles are inside an odd number of rings.
#pragma once

#include "dem/triangulate/plane_triangulation.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace orograph {

/// A flag for each triangle of `plane.mesh()`. `ring_lines` are the lines of closed rings, a line
/// as often as rings run along it.
std::vector<char> inside_rings(const PlaneTriangulation& plane, const PlaneMesh& mesh,
                               std::span<const std::uint32_t> ring_lines);

} // namespace orograph
