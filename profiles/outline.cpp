// SPDX-License-Identifier: GPL-3.0-or-later
// Edges are visited by cell: each cell (column, row) looks at its north edge, its west edge and its
// diagonal; one more column and row of empty cells closes the east and south sides.
#include "profiles/outline.hpp"

#include "profiles/tin_edges.hpp"

#include <algorithm>
#include <cmath>

namespace orograph {
namespace {

std::uint32_t index_of(const Grid& grid, int column, int row) {
  return static_cast<std::uint32_t>(grid.index(column, row));
}

// In order.
std::vector<BorderEdge> hull_edges(const Grid& grid) {
  std::vector<BorderEdge> edges;
  const int c = grid.columns - 1, r = grid.rows - 1;
  edges.reserve(2 * (static_cast<std::size_t>(c) + static_cast<std::size_t>(r)));
  const auto eastward = [&](int column, int row, bool left) {
    edges.push_back({{index_of(grid, column, row), index_of(grid, column + 1, row)}, left});
  };
  const auto southward = [&](int column, int row, bool left) {
    edges.push_back({{index_of(grid, column, row), index_of(grid, column, row + 1)}, left});
  };
  for (int row = 0; row < r; ++row) {
    if (row == 0) eastward(0, row, false);
    southward(0, row, true);
    if (row == 0)
      for (int column = 1; column < c; ++column) eastward(column, row, false);
    southward(c, row, false);
  }
  for (int column = 0; column < c; ++column) eastward(column, r, true);
  return edges;
}

// Rows of vertices in stretches, and which have all their heights: where those about it have them
// as well there is no border, which is told many times as fast as by looking at each cell.
class WholeStretches {
public:
  static constexpr int length = 64;

  template <class Height>
  WholeStretches(const Grid& grid, const Heights<Height>& heights)
      : across_((grid.columns + length - 1) / length), rows_(grid.rows) {
    whole_.reserve(static_cast<std::size_t>(across_) * static_cast<std::size_t>(rows_));
    for (int row = 0; row < rows_; ++row)
      for (int first = 0; first < grid.columns; first += length) {
        const Height* h = &heights[grid.index(first, row)];
        int missing = 0;
        for (int i = 0; i < std::min(length, grid.columns - first); ++i)
          if (h[i] != h[i]) ++missing;
        whole_.push_back(missing == 0);
      }
  }

  bool has_no_border(int stretch, int row) const {
    if (stretch == 0 || stretch + 1 == across_ || row == 0 || row + 1 == rows_) return false;
    for (int r = row - 1; r <= row + 1; ++r)
      for (int s = stretch - 1; s <= stretch + 1; ++s)
        if (!whole_[static_cast<std::size_t>(r) * static_cast<std::size_t>(across_) +
                    static_cast<std::size_t>(s)])
          return false;
    return true;
  }

private:
  int across_, rows_;
  std::vector<std::uint8_t> whole_;
};

template <class Height>
std::vector<BorderEdge> edges_with_one_side(const Grid& grid, const Heights<Height>& heights) {
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
  const WholeStretches whole(grid, heights);
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column) {
      if (column % WholeStretches::length == 0) {
        while (column < grid.columns && whole.has_no_border(column / WholeStretches::length, row))
          column += WholeStretches::length;
      }
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

template <class VertexAt>
std::vector<OutlineEdge> outline_of_border(const std::vector<BorderEdge>& border,
                                           const VertexAt& at) {
  std::vector<OutlineEdge> outline;
  outline.reserve(border.size());
  for (const auto& [edge, left] : border)
    outline.push_back(left ? OutlineEdge{at(edge.from), at(edge.to)}
                           : OutlineEdge{at(edge.to), at(edge.from)});
  return outline;
}

void put_in_order(std::vector<BorderEdge>& edges) {
  std::sort(edges.begin(), edges.end(),
            [](const BorderEdge& a, const BorderEdge& b) { return a.edge < b.edge; });
}

} // namespace

std::vector<BorderEdge> border_edges(const Grid& grid, bool all_valid) {
  if (all_valid) return hull_edges(grid);
  std::vector<BorderEdge> edges =
      std::visit([&](const auto& h) { return edges_with_one_side(grid, h); }, grid.heights_m);
  put_in_order(edges);
  return edges;
}

std::vector<BorderEdge> border_edges(const Tin& tin) {
  std::vector<BorderEdge> edges;
  for_each_edge(tin, [&](const TinEdge& e) {
    if (e.left == kNoTriangle || e.right == kNoTriangle)
      edges.push_back({e.edge, e.right == kNoTriangle});
  });
  put_in_order(edges);
  return edges;
}

std::vector<OutlineEdge> outline_of(const Grid& grid, const std::vector<BorderEdge>& border) {
  return outline_of_border(border, [&](std::uint32_t i) { return grid.vertex_m(i); });
}

std::vector<OutlineEdge> outline_of(const Tin& tin, const std::vector<BorderEdge>& border) {
  return outline_of_border(border, [&](std::uint32_t i) { return tin.vertices_m[i]; });
}

} // namespace orograph
