// SPDX-License-Identifier: GPL-3.0-or-later
// From the triangles that are kept to a Tin in an order of place.
#pragma once

#include "dem/tin.hpp"
#include "dem/triangulate/plane_triangulation.hpp"

#include <vector>

namespace orograph {

/// Vertices come along a Hilbert curve, those of no kept triangle are left out; a triangle starts
/// with its first vertex, and triangles come in the order of their vertices.
Tin order_tin(const PlaneMesh& mesh, const std::vector<char>& kept, const std::vector<Vec2>& places,
              const std::vector<double>& heights_m);

} // namespace orograph
