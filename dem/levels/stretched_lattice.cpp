// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/levels/stretched_lattice.hpp"

namespace orograph {

std::variant<PlaneLattice, EarthLattice> stretched_lattice(const Grid& grid, int columns,
                                                           int rows) {
  const double across = (grid.columns - 1.0) / (columns - 1), down = (grid.rows - 1.0) / (rows - 1);
  if (!grid.is_on_earth()) {
    PlaneLattice lattice = grid.plane();
    lattice.column_step_m = across * lattice.column_step_m;
    lattice.row_step_m = down * lattice.row_step_m;
    return lattice;
  }
  DegreeLattice degrees = grid.earth().degrees();
  degrees.lon_step_deg *= across;
  degrees.lat_step_deg *= down;
  degrees.columns = columns;
  degrees.rows = rows;
  return EarthLattice(degrees, grid.earth().frame(), grid.earth().exaggeration());
}

} // namespace orograph
