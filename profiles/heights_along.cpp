// SPDX-License-Identifier: GPL-3.0-or-later
#include "profiles/heights_along.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

namespace orograph {
namespace {

void clear(std::size_t count, HeightsAlong& out) {
  out.z_m.assign(count, std::numeric_limits<double>::quiet_NaN());
  out.is_level.assign(count, 0);
}

template <class Values>
void heights_of(const Grid& grid, const Values& heights, const View& view, const TriangleSet& level,
                double depth_m, const PlacesAlong& at, HeightsAlong& out) {
  const auto& [first, column_m, row_m] = grid.plane();
  const double area = cross(column_m, row_m);
  const auto in_cells = [&](Vec2 way) {
    return Vec2{cross(way, row_m) / area, cross(column_m, way) / area};
  };
  const Vec2 begin = in_cells(view.depth_origin_m - first + depth_m * view.forward +
                              at.begin_m * view.right),
             step = in_cells(at.step_m * view.right);
  const double columns = grid.columns - 1, rows = grid.rows - 1;
  for (std::size_t i = 0; i < at.count; ++i) {
    const Vec2 p = begin + static_cast<double>(i) * step;
    if (!(p.x >= 0 && p.y >= 0 && p.x <= columns && p.y <= rows)) continue;
    const int column = std::min(static_cast<int>(p.x), grid.columns - 2),
              row = std::min(static_cast<int>(p.y), grid.rows - 2);
    const double x = p.x - column, y = p.y - row;
    const std::size_t corner = grid.index(column, row), opposite = grid.index(column + 1, row + 1);
    const Half half = x > y ? Half::upper : Half::lower;
    const auto height = [&](std::size_t vertex) { return static_cast<double>(heights[vertex]); };
    const double z =
        half == Half::upper
            ? (1 - x) * height(corner) + (x - y) * height(corner + 1) + y * height(opposite)
            : (1 - y) * height(corner) + (y - x) * height(grid.index(column, row + 1)) +
                  x * height(opposite);
    out.z_m[i] = z * view.exaggeration - view.drop.at(at[i], depth_m);
    if (!level.empty() && level.has(grid_triangle(grid, column, row, half))) out.is_level[i] = 1;
  }
}

} // namespace

void heights_along(const Grid& grid, const View& view, const TriangleSet& level, double depth_m,
                   const PlacesAlong& at, HeightsAlong& out) {
  clear(at.count, out);
  if (grid.columns < 2 || grid.rows < 2) return;
  std::visit([&](const auto& h) { heights_of(grid, h, view, level, depth_m, at, out); },
             grid.heights_m);
}

void heights_along(const Profile& profile, const PlacesAlong& at, HeightsAlong& out) {
  clear(at.count, out);
  std::size_t span = 0;
  for (std::size_t i = 0; i < at.count; ++i) {
    const double u = at[i];
    while (span + 1 < profile.size() && profile.u_m[span + 1] <= u) ++span;
    if (span + 1 >= profile.size()) return;
    if (u < profile.u_m[span] || profile.after[span] == Span::gap) continue;
    const double share = (u - profile.u_m[span]) / (profile.u_m[span + 1] - profile.u_m[span]);
    out.z_m[i] = profile.z_m[span] + share * (profile.z_m[span + 1] - profile.z_m[span]);
    out.is_level[i] = profile.after[span] == Span::level ? 1 : 0;
  }
}

} // namespace orograph
