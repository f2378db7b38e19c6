// SPDX-License-Identifier: GPL-3.0-or-later
#include "profiles/cut_earth_grid.hpp"

#include "profiles/walk_mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace orograph {
namespace {

// Columns east and rows south of a triangle's cell.
struct Offset {
  int column, row;
};
constexpr std::array<std::array<Offset, 3>, 2> kCorners{
    {{{{0, 0}, {0, 1}, {1, 1}}}, {{{0, 0}, {1, 1}, {1, 0}}}}};
// Beyond the side opposite to corner k: in the cell so far away, in the other half, the same side
// is opposite to corner `k`.
struct Beyond {
  Offset cell;
  std::uint8_t k;
};
constexpr std::array<std::array<Beyond, 3>, 2> kBeyond{
    {{{{{0, 1}, 1}, {{0, 0}, 2}, {{-1, 0}, 0}}}, {{{{1, 0}, 2}, {{0, -1}, 0}, {{0, 0}, 1}}}}};

constexpr std::size_t at(Half half) {
  return static_cast<std::size_t>(half);
}

template <class Height>
struct GridMesh {
  using Side = GridSide;
  using Triangle = GridSide::Triangle;

  const Grid& grid;
  const EarthLattice& earth;
  const std::vector<Height>& heights;
  const View& view;
  const TriangleSet& level;

  CutVertex vertex(const Triangle& t, std::size_t k) const {
    const Offset corner = kCorners[at(t.half)][k];
    const int column = t.column + corner.column, row = t.row + corner.row;
    const std::size_t index = grid.index(column, row);
    const double height = heights[index];
    return {static_cast<std::uint32_t>(index),
            to_profile_frame(view, earth.vertex_m(column, row, height))};
  }
  std::optional<Side> across(const Side& side) const {
    const auto& [cell, k] = kBeyond[at(side.triangle.half)][side.k];
    const Triangle next{side.triangle.column + cell.column, side.triangle.row + cell.row,
                        side.triangle.half == Half::lower ? Half::upper : Half::lower};
    if (next.column < 0 || next.row < 0 || next.column + 1 >= grid.columns ||
        next.row + 1 >= grid.rows)
      return std::nullopt;
    const Offset corner = kCorners[at(next.half)][k];
    if (std::isnan(heights[grid.index(next.column + corner.column, next.row + corner.row)]))
      return std::nullopt;
    return Side{next, k};
  }
  bool is_wall(const Triangle&) const { return false; }
  Span span_in(const Triangle& t) const {
    return !level.empty() && level.has(grid_triangle(grid, t.column, t.row, t.half)) ? Span::level
                                                                                     : Span::slope;
  }
};

// The side of the one triangle that a border edge has.
GridSide side_of(const Grid& grid, const BorderEdge& border) {
  const auto columns = static_cast<std::uint32_t>(grid.columns);
  const auto [from, to] = border.edge;
  const int column = static_cast<int>(from % columns), row = static_cast<int>(from / columns);
  const std::uint32_t step = to - from;
  if (step == 1) // east: north of it or south
    return border.left ? GridSide{{column, row - 1, Half::lower}, 0}
                       : GridSide{{column, row, Half::upper}, 1};
  if (step == columns) // south: east of it or west
    return border.left ? GridSide{{column, row, Half::lower}, 2}
                       : GridSide{{column - 1, row, Half::upper}, 0};
  return border.left ? GridSide{{column, row, Half::upper}, 2}
                     : GridSide{{column, row, Half::lower}, 1};
}

BorderSides<GridSide> sides_of(const Grid& grid, const View& view,
                               std::span<const BorderEdge> border) {
  std::vector<GridSide> sides;
  sides.reserve(border.size());
  for (const BorderEdge& edge : border) sides.push_back(side_of(grid, edge));
  const auto depth = [&](const GridSide& side, std::size_t n) {
    const Offset corner = kCorners[at(side.triangle.half)][(side.k + n) % 3];
    const Vec3 vertex_m =
        grid.vertex_m(side.triangle.column + corner.column, side.triangle.row + corner.row);
    return to_profile_frame(view, vertex_m).v;
  };
  return {sides, [&](const GridSide& side) {
            const double a = depth(side, 1), b = depth(side, 2);
            return BorderSides<GridSide>::Depths{std::min(a, b), std::max(a, b)};
          }};
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
      [&]<class Height>(const std::vector<Height>& heights) {
        cut_mesh(GridMesh<Height>{grid_, grid_.earth(), heights, view_, level_}, border_, depth_m,
                 depth_m > nearest_m(), out);
      },
      grid_.heights_m);
}

} // namespace orograph
