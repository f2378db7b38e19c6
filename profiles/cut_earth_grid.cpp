// SPDX-License-Identifier: GPL-3.0-or-later
#include "profiles/cut_earth_grid.hpp"

#include "profiles/walk_mesh.hpp"

#include <algorithm>

namespace orograph {
namespace {

template <class Height>
struct CutMesh : GridMesh<EarthLattice, Height> {
  const TriangleSet& level;

  bool is_wall(const CellHalf&) const { return false; }
  Span span_in(const CellHalf& t) const {
    return !level.empty() && level.has(grid_triangle(this->grid, t.column, t.row, t.half))
               ? Span::level
               : Span::slope;
  }
};

BorderSides<GridSide> sides_of(const Grid& grid, const View& view,
                               std::span<const BorderEdge> border) {
  std::vector<GridSide> sides;
  sides.reserve(border.size());
  for (const auto& [edge, left] : border) sides.push_back(side_of(grid, edge, left));
  return std::visit(
      [&](const auto& heights) {
        const GridMesh mesh{grid, grid.earth(), heights, view};
        return BorderSides<GridSide>(sides, [&](const GridSide& side) {
          const double a = mesh.vertex(side.triangle, (side.k + 1U) % 3).at.v,
                       b = mesh.vertex(side.triangle, (side.k + 2U) % 3).at.v;
          return BorderSides<GridSide>::Depths{std::min(a, b), std::max(a, b)};
        });
      },
      grid.heights_m);
}

} // namespace

EarthGridCutter::EarthGridCutter(const Grid& grid, const View& view, const TriangleSet& level,
                                 std::span<const BorderEdge> border)
    : grid_(grid), view_(view), level_(level), border_(sides_of(grid, view, border)) {}

void EarthGridCutter::cut(double depth_m, Profile& out) const {
  out.clear();
  out.depth_m = depth_m;
  if (!(depth_m >= nearest_m() && depth_m <= farthest_m())) return;
  std::visit(
      [&]<class Height>(const Heights<Height>& heights) {
        cut_mesh(CutMesh<Height>{{grid_, grid_.earth(), heights, view_}, level_}, border_, depth_m,
                 depth_m > nearest_m(), out);
      },
      grid_.heights_m);
}

} // namespace orograph
