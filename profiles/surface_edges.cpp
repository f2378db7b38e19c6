// SPDX-License-Identifier: GPL-3.0-or-later
#include "profiles/surface_edges.hpp"

#include "profiles/slab_lines.hpp"
#include "profiles/tin_edges.hpp"

#include <algorithm>
#include <cmath>

namespace orograph {
namespace {

template <class Height>
std::vector<SurfaceEdge> edges_of(const Grid& grid, const Heights<Height>& heights) {
  const auto valid = [&](int column, int row) {
    return column >= 0 && row >= 0 && column < grid.columns && row < grid.rows &&
           !std::isnan(heights[grid.index(column, row)]);
  };
  std::vector<SurfaceEdge> edges;
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column) {
      if (!valid(column, row)) continue;
      const auto add = [&](int c, int r) {
        edges.push_back({static_cast<std::uint32_t>(grid.index(column, row)),
                         static_cast<std::uint32_t>(grid.index(c, r))});
      };
      // Each edge is there if one of its two triangles is.
      const bool east = valid(column + 1, row), south = valid(column, row + 1),
                 across = valid(column + 1, row + 1);
      if (east && (across || valid(column, row - 1))) add(column + 1, row);
      if (south && (across || valid(column - 1, row))) add(column, row + 1);
      if (across && (east || south)) add(column + 1, row + 1);
    }
  return edges;
}

} // namespace

std::vector<SurfaceEdge> edges_of(const Grid& grid) {
  return std::visit([&](const auto& heights) { return edges_of(grid, heights); }, grid.heights_m);
}

std::vector<SurfaceEdge> edges_of(const Tin& tin) {
  std::vector<SurfaceEdge> edges;
  for_each_edge(tin, [&](const TinEdge& e) { edges.push_back(e.edge); });
  std::sort(edges.begin(), edges.end());
  return edges;
}

std::vector<SurfaceEdge> edges_of(const Surface& surface) {
  return std::visit([](const auto& s) { return edges_of(s); }, surface);
}

std::vector<SurfaceEdge> brinks(const Surface& surface, const std::vector<BorderEdge>& border,
                                const View& view) {
  const Tin* tin = std::get_if<Tin>(&surface);
  const TriangleSet walls = tin ? walls_of(*tin) : TriangleSet();
  const auto is_ground_in_front = [&](SurfaceEdge edge, bool on_left) {
    const auto [from, to] = line_of(surface, view, edge);
    const double eye_on_left =
        view.is_perspective() ? from.u * to.v - to.u * from.v : from.u - to.u;
    return on_left ? eye_on_left > 0 : eye_on_left < 0;
  };
  std::vector<SurfaceEdge> edges;
  if (walls.empty()) {
    for (const auto& [edge, left] : border)
      if (is_ground_in_front(edge, left)) edges.push_back(edge);
    return edges;
  }
  const auto is_ground = [&](std::uint32_t t) { return t != kNoTriangle && !walls.has(t); };
  for_each_edge(*tin, [&](const TinEdge& e) {
    if (is_ground(e.left) != is_ground(e.right) && is_ground_in_front(e.edge, is_ground(e.left)))
      edges.push_back(e.edge);
  });
  std::sort(edges.begin(), edges.end());
  return edges;
}

std::vector<SurfaceEdge> edges_behind_walls(const Surface& surface, const View& view) {
  const Tin* tin = std::get_if<Tin>(&surface);
  return tin ? edges_behind_walls(*tin, view) : std::vector<SurfaceEdge>();
}

} // namespace orograph
