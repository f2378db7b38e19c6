// SPDX-License-Identifier: GPL-3.0-or-later
// Random grids, and a grid as the plain list of its triangles, for tests by definition.
#pragma once

#include "dem/grid.hpp"
#include "profiles/triangles.hpp"
#include "tests/support/random.hpp"

#include <array>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace orograph {

/// How a random grid lies on the ground.
struct GridLattice {
  int columns = 2, rows = 2;
  Vec2 first_vertex_m{}, column_step_m{1, 0}, row_step_m{0, -1};
};

/// Heights: whole numbers (with many equal neighbours) or any; float or double; with holes.
struct GridHeights {
  double low = 0, high = 100;
  double missing = 0; ///< probability of NaN at a vertex
  bool whole = false, in_double = false;
};

inline Grid made_grid(Random& random, const GridLattice& lattice, const GridHeights& wanted) {
  Grid grid{lattice.columns, lattice.rows,
            PlaneLattice{lattice.first_vertex_m, lattice.column_step_m, lattice.row_step_m},
            std::vector<float>()};
  std::vector<double> heights(grid.size());
  for (double& height : heights) {
    height = random.between(wanted.low, wanted.high);
    if (wanted.whole) height = std::floor(height);
    if (random.chance(wanted.missing)) height = std::numeric_limits<double>::quiet_NaN();
  }
  if (wanted.in_double)
    grid.heights_m = std::move(heights);
  else
    grid.heights_m = std::vector<float>(heights.begin(), heights.end());
  return grid;
}

/// Turned by an angle (radians, counterclockwise) and sheared eastward by `shear` a row.
inline GridLattice turned_lattice(int columns, int rows, Vec2 cell_m, double turn_rad,
                                  double shear = 0) {
  const double s = std::sin(turn_rad), c = std::cos(turn_rad);
  const Vec2 row{shear * cell_m.x, -cell_m.y};
  return {columns,
          rows,
          {},
          {c * cell_m.x, s * cell_m.x},
          {c * row.x - s * row.y, s * row.x + c * row.y}};
}

/// A triangle by its vertices' indices, counterclockwise seen from above.
struct GridTriangle {
  std::array<std::uint32_t, 3> vertices;
  int column, row;
  Half half;
};

/// Every triangle that is there, cell after cell.
inline std::vector<GridTriangle> triangles_of(const Grid& grid) {
  std::vector<GridTriangle> triangles;
  const auto at = [&](int column, int row) {
    return static_cast<std::uint32_t>(row * grid.columns + column);
  };
  const auto there = [&](std::uint32_t i) {
    return std::visit([&](const auto& h) { return !std::isnan(h[i]); }, grid.heights_m);
  };
  for (int r = 0; r + 1 < grid.rows; ++r)
    for (int c = 0; c + 1 < grid.columns; ++c) {
      const GridTriangle lower{{at(c, r), at(c, r + 1), at(c + 1, r + 1)}, c, r, Half::lower};
      const GridTriangle upper{{at(c, r), at(c + 1, r + 1), at(c + 1, r)}, c, r, Half::upper};
      for (const GridTriangle& triangle : {lower, upper})
        if (there(triangle.vertices[0]) && there(triangle.vertices[1]) &&
            there(triangle.vertices[2]))
          triangles.push_back(triangle);
    }
  return triangles;
}

/// Ground position and true height of a vertex.
inline Vec3 vertex_m(const Grid& grid, std::uint32_t index) {
  const int column = static_cast<int>(index) % grid.columns;
  const int row = static_cast<int>(index) / grid.columns;
  const double height =
      std::visit([&](const auto& h) { return static_cast<double>(h[index]); }, grid.heights_m);
  return {grid.plane().first_vertex_m.x + column * grid.plane().column_step_m.x +
              row * grid.plane().row_step_m.x,
          grid.plane().first_vertex_m.y + column * grid.plane().column_step_m.y +
              row * grid.plane().row_step_m.y,
          height};
}

using DirectedEdge = std::pair<std::uint32_t, std::uint32_t>;

/// Every triangle's three edges in its own direction, the triangle (by number) on the left.
inline std::map<DirectedEdge, std::size_t>
directed_edges(const std::vector<GridTriangle>& triangles) {
  std::map<DirectedEdge, std::size_t> edges;
  for (std::size_t i = 0; i < triangles.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k)
      edges[{triangles[i].vertices[k], triangles[i].vertices[(k + 1) % 3]}] = i;
  return edges;
}

/// The directed edges without a triangle on their right.
inline std::vector<DirectedEdge> outline_by_triangles(const Grid& grid) {
  const auto edges = directed_edges(triangles_of(grid));
  std::vector<DirectedEdge> outline;
  for (const auto& [edge, triangle] : edges)
    if (!edges.contains({edge.second, edge.first})) outline.push_back(edge);
  return outline;
}

} // namespace orograph
