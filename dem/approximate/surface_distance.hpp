// SPDX-License-Identifier: GPL-3.0-or-later
// How far a Tin over some of a grid's vertices is from the grid, in height.
#pragma once

#include "dem/approximate/lattice_triangulation.hpp"
#include "dem/grid.hpp"
#include "dem/tin.hpp"

#include <vector>

namespace orograph {

/// Greatest vertical distance at the grid's vertices: each triangle against all those that it
/// covers, its edges included. `at` tells where the Tin's vertices are in the grid. REQUIRES a Tin
/// over the grid's ground only.
double greatest_distance_at_vertices_m(const Grid& grid, const Tin& tin,
                                       const std::vector<LatticePoint>& at);

/// Greatest vertical distance where edges of the Tin cross edges of the grid (column lines, row
/// lines and diagonals) between their ends. With the one at vertices it bounds the distance
/// anywhere: both surfaces are flat on each piece of ground that is left between all those edges,
/// so that their distance is greatest at a corner of one. Cost as many edges as cross.
double greatest_distance_at_crossings_m(const Grid& grid, const Tin& tin,
                                        const std::vector<LatticePoint>& at);

} // namespace orograph
