// SPDX-License-Identifier: GPL-3.0-or-later
// A lattice of another number of vertices between the same borders.
#pragma once

#include "dem/grid.hpp"

#include <variant>

namespace orograph {

/// The lattice of `columns` times `rows` vertices that has the corners of the grid's. REQUIRES two
/// of each at least.
std::variant<PlaneLattice, EarthLattice> stretched_lattice(const Grid& grid, int columns, int rows);

} // namespace orograph
