// SPDX-License-Identifier: GPL-3.0-or-later
// Lines in a plane triangulation: heights where they are split, rings that cut, and what is inside
// of rings.
#include "dem/tin.hpp"
#include "dem/triangulate/place_order.hpp"
#include "dem/triangulate/plane_triangulation.hpp"
#include "geometry/on_all_cores.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace orograph {
namespace {

// Vertices and what lines say of their heights.
using Told = std::vector<std::pair<std::uint32_t, double>>;

// The vertices of a line between its `begin`th and `end`th get heights evenly between those two's.
void tell_between(const std::vector<std::uint32_t>& line, std::size_t begin, std::size_t end,
                  const std::vector<Vec2>& places, const std::vector<double>& heights_m,
                  Told& told) {
  const Vec2 from = places[line[begin]], along = places[line[end]] - from;
  const double low = heights_m[line[begin]], high = heights_m[line[end]];
  for (std::size_t k = begin + 1; k < end; ++k) {
    if (!std::isnan(heights_m[line[k]])) continue;
    const double share = dot(places[line[k]] - from, along) / dot(along, along);
    told.emplace_back(line[k], low + std::clamp(share, 0.0, 1.0) * (high - low));
  }
}

// Each vertex gets the mean of what was told; from the lowest on, so that equal heights stay equal.
SplitHeights take_means(Told& told, std::vector<double>& heights_m) {
  SplitHeights all;
  std::sort(told.begin(), told.end());
  for (std::size_t begin = 0, end = 0; begin < told.size(); begin = end) {
    const auto [vertex, lowest] = told[begin];
    double above = 0;
    for (end = begin; end < told.size() && told[end].first == vertex; ++end)
      above += told[end].second - lowest;
    heights_m[vertex] = lowest + above / static_cast<double>(end - begin);
    all.greatest_m = std::max(all.greatest_m, told[end - 1].second - lowest);
    ++all.vertices;
  }
  return all;
}

void make_room(const PlaneTriangulation& plane, std::vector<double>& heights_m) {
  heights_m.resize(plane.places().size(), std::numeric_limits<double>::quiet_NaN());
}

// In an order of place, so that each is found near the one before.
std::vector<Vec2> in_order(const std::vector<std::vector<Vec2>>& rings) {
  std::vector<Vec2> all, ordered;
  for (const auto& ring : rings) all.insert(all.end(), ring.begin(), ring.end());
  for (const std::uint32_t i : hilbert_order(all)) ordered.push_back(all[i]);
  return ordered;
}

double height_at(const std::vector<Share>& around, const std::vector<double>& heights_m) {
  if (around.empty()) return std::numeric_limits<double>::quiet_NaN();
  const double first = heights_m[around.front().vertex];
  double height = first;
  for (const auto& [vertex, share] : around) height += share * (heights_m[vertex] - first);
  return height;
}

void insert(PlaneTriangulation& plane, Vec2 place, std::vector<double>& heights_m) {
  const double height = height_at(plane.around(place), heights_m);
  if (plane.insert(place) == heights_m.size()) heights_m.push_back(height);
}

// Edges of all triangles with heights that the rings meet.
std::vector<Edge> edges_along(const PlaneTriangulation& plane,
                              const std::vector<std::vector<Vec2>>& rings,
                              const std::vector<double>& heights_m) {
  std::vector<Edge> edges;
  for (const auto& ring : rings)
    for (std::size_t k = 0; k < ring.size(); ++k)
      for (const auto& [a, b, c] : plane.triangles_along(ring[k], ring[(k + 1) % ring.size()]))
        if (!std::isnan(heights_m[a] + heights_m[b] + heights_m[c]))
          edges.insert(edges.end(), {{a, b}, {b, c}, {c, a}});
  return edges;
}

std::vector<std::uint64_t> odd_edges(const PlaneTriangulation& plane,
                                     std::span<const std::uint32_t> ring_lines) {
  std::vector<std::uint64_t> all, odd;
  for (const std::uint32_t number : ring_lines) {
    const auto line = plane.line(number);
    for (std::size_t k = 0; k + 1 < line.size(); ++k) all.push_back(edge_key(line[k], line[k + 1]));
  }
  std::sort(all.begin(), all.end());
  for (std::size_t begin = 0, end = 0; begin < all.size(); begin = end) {
    for (end = begin; end < all.size() && all[end] == all[begin];) ++end;
    if ((end - begin) % 2 == 1) odd.push_back(all[begin]);
  }
  return odd;
}

} // namespace

void append_edges(std::span<const std::uint32_t> polyline, bool closed, std::vector<Edge>& edges) {
  for (std::size_t k = 0; k < polyline.size(); ++k) {
    if (k + 1 == polyline.size() && !closed) break;
    const Edge edge{polyline[k], polyline[(k + 1) % polyline.size()]};
    if (edge[0] != edge[1]) edges.push_back(edge);
  }
}

std::vector<std::uint32_t> add_lines(PlaneTriangulation& plane, std::span<const Edge> edges) {
  std::vector<std::uint64_t> keys;
  keys.reserve(edges.size());
  for (const Edge& edge : edges) keys.push_back(edge_key(edge[0], edge[1]));
  std::sort(keys.begin(), keys.end());
  keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
  std::vector<std::uint32_t> added, of_edges;
  added.reserve(keys.size());
  of_edges.reserve(edges.size());
  for (const std::uint64_t key : keys)
    added.push_back(plane.add_line(static_cast<std::uint32_t>(key >> 32U),
                                   static_cast<std::uint32_t>(key & 0xffffffffU)));
  for (const Edge& edge : edges)
    of_edges.push_back(
        added[std::lower_bound(keys.begin(), keys.end(), edge_key(edge[0], edge[1])) -
              keys.begin()]);
  return of_edges;
}

SplitHeights add_heights_of_lines(const PlaneTriangulation& plane,
                                  std::span<const std::uint32_t> lines,
                                  std::vector<double>& heights_m) {
  make_room(plane, heights_m);
  std::vector<std::uint32_t> each(lines.begin(), lines.end());
  std::sort(each.begin(), each.end());
  each.erase(std::unique(each.begin(), each.end()), each.end());
  Told told;
  for (const std::uint32_t number : each) {
    const auto line = plane.line(number);
    tell_between(line, 0, line.size() - 1, plane.places(), heights_m, told);
  }
  return take_means(told, heights_m);
}

SplitHeights add_heights_between(const PlaneTriangulation& plane,
                                 std::span<const std::uint32_t> lines,
                                 std::vector<double>& heights_m) {
  make_room(plane, heights_m);
  Told told;
  for (const std::uint32_t number : lines) {
    const auto line = plane.line(number);
    std::size_t known = line.size(); // none yet
    for (std::size_t k = 0; k < line.size(); ++k) {
      if (std::isnan(heights_m[line[k]])) continue;
      if (known < k) tell_between(line, known, k, plane.places(), heights_m, told);
      known = k;
    }
  }
  return take_means(told, heights_m);
}

std::vector<std::uint32_t> cut_by_rings(PlaneTriangulation& plane,
                                        const std::vector<std::vector<Vec2>>& rings,
                                        const std::vector<std::uint32_t>& breaklines,
                                        std::vector<double>& heights_m) {
  const auto ordered = in_order(rings);
  if (ordered.empty()) return {};

  // The hull first: ring vertices beyond it must not change what is within. With them in, all rings
  // are within the new hull.
  std::vector<std::uint32_t> fixed = add_lines(plane, plane.hull_edges());
  for (const Vec2 place : ordered)
    if (plane.around(place).empty()) insert(plane, place, heights_m);
  // Then triangles that will be cut, so that they are split and nothing else.
  const auto along = add_lines(plane, edges_along(plane, rings, heights_m));
  fixed.insert(fixed.end(), along.begin(), along.end());
  for (const Vec2 place : ordered) {
    throw_if_stopped();
    insert(plane, place, heights_m);
  }

  std::vector<Edge> edges;
  for (const auto& ring : rings) {
    std::vector<std::uint32_t> vertices;
    for (const Vec2 place : ring) vertices.push_back(plane.insert(place));
    append_edges(vertices, true, edges);
  }
  const auto lines = add_lines(plane, edges);

  // The triangles' edges tell the heights where rings cross them. Where rounding pushed a ring
  // across a breakline farther off, that tells it. And rings that cross each other within a
  // triangle are straight there.
  add_heights_of_lines(plane, fixed, heights_m);
  add_heights_of_lines(plane, breaklines, heights_m);
  add_heights_between(plane, lines, heights_m);
  return lines;
}

// From the outside inwards: crossing an edge that an odd number of rings run along changes sides.
std::vector<char> inside_rings(const PlaneTriangulation& plane, const PlaneMesh& mesh,
                               std::span<const std::uint32_t> ring_lines) {
  const std::vector<std::uint64_t> odd = odd_edges(plane, ring_lines);
  std::vector<char> on_ring(plane.places().size(), 0); // most edges needn't be looked up
  for (const std::uint64_t key : odd) on_ring[key >> 32U] = on_ring[key & 0xffffffffU] = 1;
  const auto changes_sides = [&](std::size_t triangle, int k) {
    const std::uint32_t a = mesh.triangles[triangle][(k + 1) % 3];
    const std::uint32_t b = mesh.triangles[triangle][(k + 2) % 3];
    return on_ring[a] && on_ring[b] && std::binary_search(odd.begin(), odd.end(), edge_key(a, b));
  };

  constexpr char unknown = 2;
  std::vector<char> inside(mesh.triangles.size(), unknown);
  std::vector<std::uint32_t> open;
  const auto reach = [&](std::uint32_t triangle, bool is_inside) {
    if (inside[triangle] != unknown) return;
    inside[triangle] = is_inside;
    open.push_back(triangle);
  };
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k)
      if (mesh.neighbours[t][k] == kNoTriangle) reach(t, changes_sides(t, k));
  while (!open.empty()) {
    const std::uint32_t t = open.back();
    open.pop_back();
    for (int k = 0; k < 3; ++k)
      if (mesh.neighbours[t][k] != kNoTriangle)
        reach(mesh.neighbours[t][k], (inside[t] != 0) != changes_sides(t, k));
  }
  return inside;
}

} // namespace orograph
