// SPDX-License-Identifier: GPL-3.0-or-later
#include "profiles/outline.hpp"

#include "geometry/on_all_cores.hpp"
#include "profiles/surface_edges.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <tuple>
#include <utility>
#include <variant>

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

// A row's vertices, or cells by the vertex to their north-west, a bit each: those of 64 are asked
// at once.
using RowBits = std::vector<std::uint64_t>;

template <class Height>
std::uint64_t bits_of_heights(const Height* heights, int count) {
  int missing = 0;
  for (int i = 0; i < count; ++i) missing += heights[i] != heights[i];
  if (missing == count) return 0;
  if (missing == 0) return ~std::uint64_t{0} >> (64 - count);
  std::uint64_t bits = 0;
  for (int i = 0; i < count; ++i) bits |= std::uint64_t{heights[i] == heights[i]} << i;
  return bits;
}

// The vertices of a row that have a height; none of a row beyond the grid's end.
template <class Height>
void find_vertices(const Grid& grid, const Heights<Height>& heights, int row, RowBits& vertices) {
  for (std::size_t w = 0; w < vertices.size(); ++w) {
    const int first = static_cast<int>(64 * w);
    vertices[w] = row < grid.rows ? bits_of_heights(&heights[grid.index(first, row)],
                                                    std::min(64, grid.columns - first))
                                  : 0;
  }
}

// The triangles of the cells south of a row that have their three heights.
struct RowTriangles {
  RowBits lower, upper;
};
void find_triangles(const RowBits& north, const RowBits& south, RowTriangles& triangles) {
  // Bit c is the vertex one column east.
  const auto to_east = [](const RowBits& row, std::size_t w) {
    return row[w] >> 1 | (w + 1 < row.size() ? row[w + 1] << 63 : 0);
  };
  for (std::size_t w = 0; w < north.size(); ++w) {
    const std::uint64_t diagonal = north[w] & to_east(south, w);
    triangles.lower[w] = diagonal & south[w];
    triangles.upper[w] = diagonal & to_east(north, w);
  }
}

// In order: each vertex has the edge that runs east, the one that runs south, and the diagonal of
// the cell between them. `before` are the triangles north of the row, `here` those south of it.
template <class Height>
std::vector<BorderEdge> edges_with_one_side(const Grid& grid, const Heights<Height>& heights) {
  const auto words = static_cast<std::size_t>((grid.columns + 63) / 64);
  RowBits vertices(words), next_vertices(words);
  RowTriangles before{RowBits(words), RowBits(words)}, here = before;
  std::vector<BorderEdge> edges;
  find_vertices(grid, heights, 0, vertices);
  for (int row = 0; row < grid.rows; ++row) {
    throw_if_stopped();
    find_vertices(grid, heights, row + 1, next_vertices);
    find_triangles(vertices, next_vertices, here);
    for (std::size_t w = 0; w < words; ++w) {
      const std::uint64_t lower = here.lower[w], upper = here.upper[w], north = before.lower[w],
                          west = upper << 1 | (w > 0 ? here.upper[w - 1] >> 63 : 0);
      const std::uint64_t east_edge = north ^ upper, south_edge = west ^ lower,
                          diagonal = lower ^ upper;
      for (std::uint64_t left = east_edge | south_edge | diagonal; left != 0; left &= left - 1) {
        const int bit = std::countr_zero(left), column = static_cast<int>(64 * w) + bit;
        const auto has = [&](std::uint64_t bits) { return (bits >> bit & 1U) != 0; };
        const std::uint32_t from = index_of(grid, column, row);
        const auto to = [&](int c, int r) {
          return SurfaceEdge{from, index_of(grid, column + c, row + r)};
        };
        if (has(east_edge)) edges.push_back({to(1, 0), has(north)});
        if (has(south_edge)) edges.push_back({to(0, 1), has(lower)});
        if (has(diagonal)) edges.push_back({to(1, 1), has(upper)});
      }
    }
    std::swap(vertices, next_vertices);
    std::swap(before, here);
  }
  return edges;
}

template <class VertexAt>
std::vector<OutlineEdge> outline_of_border(const std::vector<BorderEdge>& border,
                                           const VertexAt& at) {
  std::vector<OutlineEdge> outline;
  outline.reserve(border.size());
  for (const auto& [edge, left] : border) {
    throw_if_stopped(outline.size());
    outline.push_back(left ? OutlineEdge{at(edge.from), at(edge.to)}
                           : OutlineEdge{at(edge.to), at(edge.from)});
  }
  return outline;
}

} // namespace

std::vector<BorderEdge> border_edges(const Grid& grid, bool all_valid) {
  if (all_valid) return hull_edges(grid);
  return std::visit([&](const auto& h) { return edges_with_one_side(grid, h); }, grid.heights_m);
}

std::vector<BorderEdge> border_edges(const Tin& tin) {
  std::vector<BorderEdge> edges;
  for_each_edge(tin, [&](const TinEdge& e) {
    if (e.left == kNoTriangle || e.right == kNoTriangle)
      edges.push_back({e.edge, e.right == kNoTriangle});
  });
  std::size_t steps = 0;
  const StoppableLess less(steps);
  std::sort(edges.begin(), edges.end(),
            [&](const BorderEdge& a, const BorderEdge& b) { return less(a.edge, b.edge); });
  return edges;
}

std::vector<OutlineEdge> outline_of(const Grid& grid, const std::vector<BorderEdge>& border) {
  return outline_of_border(border, [&](std::uint32_t i) { return grid.vertex_m(i); });
}

std::vector<OutlineEdge> outline_of(const Tin& tin, const std::vector<BorderEdge>& border) {
  return outline_of_border(border, [&](std::uint32_t i) { return tin.vertices_m[i]; });
}

namespace {

std::uint32_t tail(const BorderEdge& b) {
  return b.left ? b.edge.from : b.edge.to;
}
std::uint32_t head(const BorderEdge& b) {
  return b.left ? b.edge.to : b.edge.from;
}

// The edges' numbers, by their vertex of higher index. (They come by that of lower index.)
std::vector<std::uint32_t> by_higher_vertex(const std::vector<BorderEdge>& border) {
  std::vector<std::uint64_t> keys(border.size());
  for (std::uint64_t i = 0; i < border.size(); ++i)
    keys[i] = std::uint64_t{border[i].edge.to} << 32U | i;
  std::size_t steps = 0;
  std::sort(keys.begin(), keys.end(), StoppableLess(steps));
  return {keys.begin(), keys.end()}; // the lower halves
}

// Where several loops meet: seen from above and counterclockwise, missing ground begins at an
// arriving edge and ends at a leaving one, along which its loop goes on.
template <class At>
void part_loops(const std::vector<BorderEdge>& border, const At& at, std::uint32_t vertex,
                const std::vector<std::uint32_t>& arriving,
                const std::vector<std::uint32_t>& leaving, std::vector<std::uint32_t>& next) {
  struct Spoke {
    double angle;
    bool leaves;
    std::uint32_t edge;
    bool operator<(const Spoke& o) const {
      return std::tie(angle, leaves, edge) < std::tie(o.angle, o.leaves, o.edge);
    }
  };
  std::vector<Spoke> spokes;
  const auto add = [&](std::uint32_t edge, std::uint32_t other, bool leaves) {
    const Vec2 along = at(other) - at(vertex);
    spokes.push_back({std::atan2(along.y, along.x), leaves, edge});
  };
  for (const std::uint32_t edge : arriving) add(edge, tail(border[edge]), false);
  for (const std::uint32_t edge : leaving) add(edge, head(border[edge]), true);
  std::sort(spokes.begin(), spokes.end());
  std::vector<bool> taken(spokes.size());
  for (std::size_t i = 0; i < spokes.size(); ++i) {
    if (spokes[i].leaves) continue;
    std::size_t k = i;
    while (!spokes[k].leaves || taken[k]) k = (k + 1) % spokes.size();
    taken[k] = true;
    next[spokes[i].edge] = spokes[k].edge;
  }
}

// The edge that follows each one on its loop. As many edges leave a vertex as arrive at it.
template <class At>
std::vector<std::uint32_t> following_edges(const std::vector<BorderEdge>& border, const At& at) {
  const auto count = static_cast<std::uint32_t>(border.size());
  const std::vector<std::uint32_t> by_higher = by_higher_vertex(border);
  std::vector<std::uint32_t> next(count), arriving, leaving;
  std::size_t step = 0;
  for (std::uint32_t lower = 0, higher = 0; higher < count;) {
    throw_if_stopped(step++);
    std::uint32_t vertex = border[by_higher[higher]].edge.to;
    if (lower < count) vertex = std::min(vertex, border[lower].edge.from);
    arriving.clear();
    leaving.clear();
    for (; lower < count && border[lower].edge.from == vertex; ++lower)
      (border[lower].left ? leaving : arriving).push_back(lower);
    for (; higher < count && border[by_higher[higher]].edge.to == vertex; ++higher)
      (border[by_higher[higher]].left ? arriving : leaving).push_back(by_higher[higher]);
    if (arriving.size() == 1)
      next[arriving.front()] = leaving.front();
    else
      part_loops(border, at, vertex, arriving, leaving, next);
  }
  return next;
}

template <class At>
std::vector<bool> clockwise_loops(const std::vector<BorderEdge>& border, const At& at) {
  const std::vector<std::uint32_t> next = following_edges(border, at);
  std::vector<bool> clockwise(border.size()), walked(border.size());
  std::size_t step = 0;
  for (std::uint32_t first = 0; first < border.size(); ++first) {
    throw_if_stopped(step++);
    if (walked[first]) continue;
    const Vec2 origin = at(tail(border[first]));
    double area = 0, rounding = 0; // twice the area
    std::uint32_t i = first;
    do {
      throw_if_stopped(step++);
      walked[i] = true;
      const Vec2 a = at(tail(border[i])) - origin, b = at(head(border[i])) - origin;
      area += cross(a, b);
      rounding += std::abs(a.x * b.y) + std::abs(a.y * b.x);
      i = next[i];
    } while (i != first);
    constexpr double kRounding = 1e-10; // what a crack between two walls has is far less
    if (area >= -kRounding * rounding) continue;
    do {
      clockwise[i] = true;
      i = next[i];
    } while (i != first);
  }
  return clockwise;
}

} // namespace

std::vector<bool> around_voids(const Grid& grid, const std::vector<BorderEdge>& border) {
  // In columns and rows, which are whole numbers: nothing is rounded.
  const auto columns = static_cast<std::uint32_t>(grid.columns);
  return clockwise_loops(border, [columns](std::uint32_t i) {
    return Vec2{static_cast<double>(i % columns), -static_cast<double>(i / columns)};
  });
}

std::vector<bool> around_voids(const Tin& tin, const std::vector<BorderEdge>& border) {
  return clockwise_loops(border, [&](std::uint32_t i) {
    return Vec2{tin.vertices_m[i].x, tin.vertices_m[i].y};
  });
}

std::vector<bool> around_voids(const Surface& surface, const std::vector<BorderEdge>& border) {
  return std::visit([&](const auto& s) { return around_voids(s, border); }, surface);
}

} // namespace orograph
