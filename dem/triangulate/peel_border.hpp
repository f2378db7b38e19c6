// SPDX-License-Identifier: GPL-3.0-or-later
// Taking long triangles away from the border inwards.
#pragma once

#include "dem/triangulate/plane_triangulation.hpp"

#include <cstdint>
#include <vector>

namespace orograph {

/// A triangle that is kept, has nothing kept beyond one of its edges and has an edge longer than
/// `max_edge_m`, is kept no more; until there is none. Returns how many went.
std::uint64_t peel_border(const PlaneMesh& mesh, const std::vector<Vec2>& places, double max_edge_m,
                          std::vector<char>& kept);

/// The least `max_edge_m` by which something would stay of the kept triangles.
double least_max_edge_m(const PlaneMesh& mesh, const std::vector<Vec2>& places,
                        const std::vector<char>& kept);

} // namespace orograph
