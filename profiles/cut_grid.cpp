// SPDX-License-Identifier: GPL-3.0-or-later
#include "profiles/cut_grid.hpp"

#include "profiles/walk_grid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace orograph {

GridCutter::GridCutter(const Grid& grid, const View& view, const TriangleSet& level)
    : grid_(grid), view_(view), level_(level), nearest_m_(std::numeric_limits<double>::infinity()),
      farthest_m_(-nearest_m_) {
  const PlaneLattice& lattice = grid.plane();
  double greatest = 0;
  for (const int column : {0, grid.columns - 1})
    for (const int row : {0, grid.rows - 1}) {
      const Vec2 at = lattice.position_m(column, row) - view.depth_origin_m;
      const double v = dot(at, view.forward);
      nearest_m_ = std::min(nearest_m_, v);
      farthest_m_ = std::max(farthest_m_, v);
      greatest = std::max({greatest, std::abs(at.x), std::abs(at.y),
                           length(lattice.position_m(column, row)), std::abs(v)});
    }
  // Depth is reckoned by some eight roundings of numbers up to `greatest`: steps that are either
  // exactly zero by construction (axis-parallel) or well above that rise or fall strictly.
  const double rounding = 16 * std::numeric_limits<double>::epsilon() * greatest;
  const auto monotone = [&](Vec2 step) {
    const double v = dot(step, view.forward);
    const bool parallel = step.x * view.forward.x == 0 && step.y * view.forward.y == 0;
    return parallel || std::abs(v) > rounding;
  };
  depth_monotone_ = monotone(lattice.column_step_m) && monotone(lattice.row_step_m);
  const bool diagonals_too = monotone(lattice.column_step_m + lattice.row_step_m);
  if (is_upright(grid))
    by_lines_.emplace(grid, view, level, depth_monotone_ && diagonals_too ? 0 : rounding);
}

void GridCutter::cut(double depth_m, std::span<const URange> ranges, Profile& out) const {
  out.depth_m = depth_m;
  out.clear();
  if (!(depth_m >= nearest_m_ && depth_m <= farthest_m_)) return;
  const GridPlane plane{depth_m, depth_m > nearest_m_};
  const auto by_lines = [&](const URange& range) { return by_lines_->cut(plane, range, out); };
  if (by_lines_ && std::all_of(ranges.begin(), ranges.end(), by_lines)) return;
  out.clear();
  walk_grid(grid_, view_, level_, plane, depth_monotone_, out);
}

} // namespace orograph
