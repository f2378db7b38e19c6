// SPDX-License-Identifier: GPL-3.0-or-later
#include "naming/dominance.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

namespace orograph {
namespace {

// At a vertex: to the next column and to the next row.
struct Steps {
  Vec2 column_m, row_m;
};

Steps steps_at(const Grid& grid, int column, int row) {
  const int right = column + 1 < grid.columns ? 1 : -1, down = row + 1 < grid.rows ? 1 : -1;
  return std::visit(
      [&](const auto& lattice) {
        const Vec3 here = lattice.vertex_m(column, row, 0),
                   beside = lattice.vertex_m(column + right, row, 0),
                   below = lattice.vertex_m(column, row + down, 0);
        return Steps{right * Vec2{beside.x - here.x, beside.y - here.y},
                     down * Vec2{below.x - here.x, below.y - here.y}};
      },
      grid.lattice);
}

} // namespace

double dominance_m(const Grid& grid, std::uint32_t vertex, Vec2 across) {
  const auto columns = static_cast<std::uint32_t>(grid.columns);
  const int column = static_cast<int>(vertex % columns), row = static_cast<int>(vertex / columns);
  const auto [column_m, row_m] = steps_at(grid, column, row);
  const double area = cross(column_m, row_m);
  const double cell_m = std::min(length(column_m), length(row_m));
  if (!(cell_m > 0) || area == 0) return 0;
  const Vec2 step{cell_m * cross(across, row_m) / area, cell_m * cross(column_m, across) / area};
  const int count = static_cast<int>(kDominanceReach_m / cell_m);
  const double own_m = grid.height_m(column, row);
  const auto low_m = [&](double side) {
    double lowest = own_m;
    for (int i = 1; i <= count; ++i) {
      const double c = std::round(column + side * i * step.x),
                   r = std::round(row + side * i * step.y);
      if (!(c >= 0 && r >= 0 && c < grid.columns && r < grid.rows)) break;
      const double height_m = grid.height_m(static_cast<int>(c), static_cast<int>(r));
      if (!(height_m <= own_m)) break; // higher, or none
      lowest = std::min(lowest, height_m);
    }
    return lowest;
  };
  return own_m - std::max(low_m(-1), low_m(1));
}

} // namespace orograph
