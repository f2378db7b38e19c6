// SPDX-License-Identifier: GPL-3.0-or-later
#include "profiles/line_places.hpp"

#include <algorithm>
#include <functional>

namespace orograph {

bool is_upright(const Grid& grid) {
  return !grid.is_on_earth() && grid.plane().column_step_m.y == 0 && grid.plane().row_step_m.x == 0;
}

LinePlaces::LinePlaces(const Grid& grid, const View& view) {
  const auto& [first_m, column_step_m, row_step_m] = grid.plane();
  for (int c = -kBeside; c < grid.columns + kBeside; ++c) {
    const double x = first_m.x + c * column_step_m.x - view.depth_origin_m.x;
    column_u.push_back(x * view.right.x);
    column_v.push_back(x * view.forward.x);
  }
  for (int r = -kBeside; r < grid.rows + kBeside; ++r) {
    const double y = first_m.y + r * row_step_m.y - view.depth_origin_m.y;
    row_u.push_back(y * view.right.y);
    row_v.push_back(y * view.forward.y);
  }
}

std::vector<double> row_depths(const Grid& grid, const View& view) {
  if (!is_upright(grid) || (view.forward.x != 0 && view.forward.y != 0)) return {};
  const LinePlaces places(grid, view);
  std::vector<double> depths_m;
  if (view.forward.x == 0)
    for (int row = 0; row < grid.rows; ++row) depths_m.push_back(places.v(0, row));
  else
    for (int column = 0; column < grid.columns; ++column) depths_m.push_back(places.v(column, 0));
  if (depths_m.front() > depths_m.back()) std::ranges::reverse(depths_m);
  const bool rise = std::ranges::adjacent_find(depths_m, std::greater_equal<>()) == depths_m.end();
  return rise ? depths_m : std::vector<double>();
}

} // namespace orograph
