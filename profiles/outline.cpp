// SPDX-License-Identifier: GPL-3.0-or-later
// Edges are visited by cell: each cell (column, row) looks at its north edge, its west edge and its
// diagonal; one more column and row of empty cells closes the east and south sides.
#include "profiles/outline.hpp"

#include <cmath>

namespace orograph {
namespace {

std::uint32_t index_of(const Grid& grid, int column, int row) {
  return static_cast<std::uint32_t>(grid.index(column, row));
}

std::vector<BorderEdge> hull_edges(const Grid& grid) {
  std::vector<BorderEdge> edges;
  const int c = grid.columns - 1, r = grid.rows - 1;
  for (int column = 0; column < c; ++column) {
    edges.push_back({{index_of(grid, column, 0), index_of(grid, column + 1, 0)}, false});
    edges.push_back({{index_of(grid, column, r), index_of(grid, column + 1, r)}, true});
  }
  for (int row = 0; row < r; ++row) {
    edges.push_back({{index_of(grid, 0, row), index_of(grid, 0, row + 1)}, true});
    edges.push_back({{index_of(grid, c, row), index_of(grid, c, row + 1)}, false});
  }
  return edges;
}

template <class Height>
std::vector<BorderEdge> edges_with_one_side(const Grid& grid, const std::vector<Height>& heights) {
  const auto valid = [&](int column, int row) {
    return column >= 0 && row >= 0 && column < grid.columns && row < grid.rows &&
           !std::isnan(heights[grid.index(column, row)]);
  };
  const auto lower = [&](int column, int row) {
    return valid(column, row) && valid(column, row + 1) && valid(column + 1, row + 1);
  };
  const auto upper = [&](int column, int row) {
    return valid(column, row) && valid(column + 1, row) && valid(column + 1, row + 1);
  };
  std::vector<BorderEdge> edges;
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column) {
      if (!valid(column, row)) continue;
      const std::uint32_t here = index_of(grid, column, row);
      const bool lower_here = lower(column, row), upper_here = upper(column, row);
      if (valid(column + 1, row)) {
        const bool north = lower(column, row - 1);
        if (north != upper_here) edges.push_back({{here, index_of(grid, column + 1, row)}, north});
      }
      if (valid(column, row + 1)) {
        const bool west = upper(column - 1, row);
        if (west != lower_here)
          edges.push_back({{here, index_of(grid, column, row + 1)}, lower_here});
      }
      if (lower_here != upper_here)
        edges.push_back({{here, index_of(grid, column + 1, row + 1)}, upper_here});
    }
  return edges;
}

Vec3 vertex_at(const Grid& grid, std::uint32_t index) {
  const auto columns = static_cast<std::uint32_t>(grid.columns);
  const int column = static_cast<int>(index % columns), row = static_cast<int>(index / columns);
  const Vec2 at = grid.position_m(column, row);
  return {at.x, at.y, grid.height_m(column, row)};
}

} // namespace

std::vector<BorderEdge> border_edges(const Grid& grid, bool all_valid) {
  if (all_valid) return hull_edges(grid);
  return std::visit([&](const auto& heights) { return edges_with_one_side(grid, heights); },
                    grid.heights_m);
}

std::vector<OutlineEdge> outline_of(const Grid& grid, const std::vector<BorderEdge>& border) {
  std::vector<OutlineEdge> outline;
  outline.reserve(border.size());
  for (const auto& [edge, left] : border) {
    const Vec3 from = vertex_at(grid, edge.from), to = vertex_at(grid, edge.to);
    outline.push_back(left ? OutlineEdge{from, to} : OutlineEdge{to, from});
  }
  return outline;
}

} // namespace orograph
