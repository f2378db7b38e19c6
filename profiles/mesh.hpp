// SPDX-License-Identifier: GPL-3.0-or-later
// A grid and a TIN as triangles to walk over, in the profile frame.
#pragma once

#include "dem/grid.hpp"
#include "dem/tin.hpp"
#include "geometry/profile_point.hpp"
#include "profiles/triangles.hpp"
#include "view/view.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace orograph {

/// A vertex of a grid or a TIN in the profile frame.
struct MeshVertex {
  std::uint32_t index;
  ProfilePoint at;
};

/// A grid's vertex by its place among the others.
struct CellVertex {
  int column, row;
};

/// A grid's triangle by its cell, columns east and rows south of the grid's first.
struct CellHalf {
  int column, row;
  Half half;
};

/// The side of a triangle opposite to its corner k: lower triangles have the corners north-west,
/// south-west, south-east, upper ones north-west, south-east, north-east.
struct GridSide {
  CellHalf triangle;
  std::uint8_t k;
};

namespace grid_mesh {

struct Offset {
  int column, row;
};
inline constexpr Offset kCorners[2][3] = {{{0, 0}, {0, 1}, {1, 1}}, {{0, 0}, {1, 1}, {1, 0}}};

// Beyond the side opposite to corner k: in the cell so far away, in the other half, the same side
// is opposite to corner `k`.
struct Beyond {
  Offset cell;
  std::uint8_t k;
};
inline constexpr Beyond kBeyond[2][3] = {{{{0, 1}, 1}, {{0, 0}, 2}, {{-1, 0}, 0}},
                                         {{{1, 0}, 2}, {{0, -1}, 0}, {{0, 0}, 1}}};

} // namespace grid_mesh

/// The side, along an edge, of the triangle on its left (columns east and rows south) or right,
/// whether that triangle is there or not.
inline GridSide side_of(const Grid& grid, SurfaceEdge edge, bool left) {
  const auto columns = static_cast<std::uint32_t>(grid.columns);
  const int column = static_cast<int>(edge.from % columns),
            row = static_cast<int>(edge.from / columns);
  const std::uint32_t step = edge.to - edge.from;
  if (step == 1) // east: north of it or south
    return left ? GridSide{{column, row - 1, Half::lower}, 0}
                : GridSide{{column, row, Half::upper}, 1};
  if (step == columns) // south: east of it or west
    return left ? GridSide{{column, row, Half::lower}, 2}
                : GridSide{{column - 1, row, Half::upper}, 0};
  return left ? GridSide{{column, row, Half::upper}, 2} : GridSide{{column, row, Half::lower}, 1};
}

template <class Lattice, class Height>
struct GridMesh {
  using Side = GridSide;

  const Grid& grid;
  const Lattice& lattice; ///< the grid's
  const Heights<Height>& heights;
  const View& view;

  CellVertex corner(const CellHalf& t, std::size_t k) const {
    const grid_mesh::Offset offset = grid_mesh::kCorners[static_cast<int>(t.half)][k];
    return {t.column + offset.column, t.row + offset.row};
  }
  std::uint32_t index(const CellHalf& t, std::size_t k) const {
    const auto [column, row] = corner(t, k);
    return static_cast<std::uint32_t>(grid.index(column, row));
  }
  MeshVertex vertex(const CellHalf& t, std::size_t k) const {
    const auto [column, row] = corner(t, k);
    const std::uint32_t i = index(t, k);
    return {i, to_profile_frame(view, lattice.vertex_m(column, row, heights[i]))};
  }
  std::optional<Side> across(const Side& side) const {
    const CellHalf& t = side.triangle;
    const auto& [cell, k] = grid_mesh::kBeyond[static_cast<int>(t.half)][side.k];
    return if_there({{t.column + cell.column, t.row + cell.row,
                      t.half == Half::lower ? Half::upper : Half::lower},
                     k});
  }
  /// The side itself, if its triangle is there. REQUIRES that its two vertices are, unless they are
  /// beyond the grid.
  std::optional<Side> if_there(const Side& side) const {
    const auto& [column, row, half] = side.triangle;
    if (column < 0 || row < 0 || column + 1 >= grid.columns || row + 1 >= grid.rows)
      return std::nullopt;
    const grid_mesh::Offset apex = grid_mesh::kCorners[static_cast<int>(half)][side.k];
    if (std::isnan(heights[grid.index(column + apex.column, row + apex.row)])) return std::nullopt;
    return side;
  }
};

/// The side of a TIN's triangle opposite to its corner k.
struct TinSide {
  std::uint32_t triangle;
  std::uint8_t k;
};

struct TinMesh {
  using Side = TinSide;

  const Tin& tin;
  const View& view;

  std::uint32_t index(std::uint32_t t, std::size_t k) const { return tin.triangles[t][k]; }
  MeshVertex vertex(std::uint32_t t, std::size_t k) const {
    const std::uint32_t i = index(t, k);
    return {i, to_profile_frame(view, tin.vertices_m[i])};
  }
  std::optional<Side> across(const Side& side) const {
    const std::uint32_t next = tin.neighbours[side.triangle][side.k];
    if (next == kNoTriangle) return std::nullopt;
    const auto& back = tin.neighbours[next];
    const auto k = std::find(back.begin(), back.end(), side.triangle) - back.begin();
    return Side{next, static_cast<std::uint8_t>(k)};
  }
};

} // namespace orograph
