// SPDX-License-Identifier: GPL-3.0-or-later
// A rectangle of a grid as a grid of its own.
#pragma once

#include "dem/grid.hpp"

#include <variant>

namespace orograph {

/// Vertices of a grid, from the first column and row on.
struct GridPart {
  int first_column = 0, first_row = 0, columns = 0, rows = 0;
};

/// Where the part's vertices are: it needs no heights.
std::variant<PlaneLattice, EarthLattice> lattice_of_part(const Grid& grid, const GridPart& part);

/// The vertices where they are, in the same frame, with copies of their heights. REQUIRES a part
/// that lies in the grid, of two columns and rows at least. Cost: that of copying.
Grid part_of_grid(const Grid& grid, const GridPart& part);

} // namespace orograph
