// SPDX-License-Identifier: GPL-3.0-or-later
// A grid's own triangles as a Tin.
#pragma once

#include "dem/grid.hpp"
#include "dem/tin.hpp"

namespace orograph {

/// The Tin of the grid's own triangles: the same surface. Vertices keep their order; those without
/// a triangle are left out. Triangles go cell after cell, the lower one of a cell before its upper
/// one. A grid without a triangle gives an empty Tin. Cost and memory O(vertices), at the speed of
/// memory. REQUIRES fewer than 2^31 vertices and steps that span a plane, whichever way round.
Tin tin_of(const Grid& grid);

} // namespace orograph
