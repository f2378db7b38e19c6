// SPDX-License-Identifier: GPL-3.0-or-later
// A grid's own triangles as a Tin.
#pragma once

#include "dem/grid.hpp"
#include "dem/tin.hpp"

#include <functional>

namespace orograph {

struct CellRow;

/// The Tin of the grid's own triangles: the same surface. Vertices keep their order; those without
/// a triangle are left out. Triangles go cell after cell, the lower one of a cell before its upper
/// one. A grid without a triangle gives an empty Tin. Cost and memory O(vertices), at the speed of
/// memory. REQUIRES fewer than 2^31 vertices and steps that span a plane, whichever way round.
Tin tin_of(const Grid& grid);

/// The same of some of its triangles. `leave_out` is called with each row of cells, by the number
/// of the row of vertices north of it, more than once, and takes triangles away. Memory grows with
/// the triangles that are left.
Tin tin_of(const Grid& grid, const std::function<void(int row, CellRow& cells)>& leave_out);

} // namespace orograph
