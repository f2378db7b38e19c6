// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/levels/part_of_grid.hpp"

#include <cstddef>
#include <vector>

namespace orograph {

std::variant<PlaneLattice, EarthLattice> lattice_of_part(const Grid& grid, const GridPart& part) {
  if (!grid.is_on_earth()) {
    PlaneLattice lattice = grid.plane();
    lattice.first_vertex_m = lattice.position_m(part.first_column, part.first_row);
    return lattice;
  }
  DegreeLattice degrees = grid.earth().degrees();
  degrees.first_lon_deg = degrees.lon_deg(part.first_column);
  degrees.first_lat_deg = degrees.lat_deg(part.first_row);
  degrees.columns = part.columns;
  degrees.rows = part.rows;
  return EarthLattice(degrees, grid.earth().frame(), grid.earth().exaggeration());
}

Grid part_of_grid(const Grid& grid, const GridPart& part) {
  const auto copy = [&]<class Height>(const Heights<Height>& heights) {
    std::vector<Height> out;
    out.reserve(static_cast<std::size_t>(part.columns) * static_cast<std::size_t>(part.rows));
    for (int row = 0; row < part.rows; ++row) {
      const Height* const first =
          heights.data() + grid.index(part.first_column, part.first_row + row);
      out.insert(out.end(), first, first + part.columns);
    }
    return std::variant<Heights<float>, Heights<double>>(Heights<Height>(std::move(out)));
  };
  return {part.columns, part.rows, lattice_of_part(grid, part), std::visit(copy, grid.heights_m)};
}

} // namespace orograph
