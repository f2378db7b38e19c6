// SPDX-License-Identifier: GPL-3.0-or-later
// From a triangulation of a grid's vertices to a Tin on the ground.
#pragma once

#include "dem/approximate/lattice_triangulation.hpp"
#include "dem/grid.hpp"
#include "dem/tin.hpp"

#include <vector>

namespace orograph {

struct LatticeTin {
  Tin tin;
  std::vector<LatticePoint> at; ///< where its vertices are in the grid
};

/// The triangles for which `wanted` isn't 0, with the grid's positions and heights. Vertices in
/// row-major order; each triangle begins with its vertex of lowest index, and triangles are in the
/// order of their vertices, however the triangulation came about.
LatticeTin lattice_tin(const Grid& grid, const LatticeTriangulation& triangulation,
                       const std::vector<unsigned char>& wanted);

} // namespace orograph
