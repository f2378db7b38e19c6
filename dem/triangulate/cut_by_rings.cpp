// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/triangulate/cut_by_rings.hpp"

#include "dem/triangulate/hilbert_order.hpp"
#include "dem/triangulate/merge_places.hpp"
#include "dem/triangulate/plane_lines.hpp"

#include <cmath>
#include <limits>

namespace orograph {
namespace {

std::vector<std::vector<Vec2>> places_of(const std::vector<BoundaryRing>& rings) {
  std::vector<std::vector<Vec2>> all;
  for (const BoundaryRing& ring : rings) {
    if (has_heights(ring)) continue;
    auto& places = all.emplace_back();
    for (const Vec3& p : ring.points_m) places.push_back({p.x + 0.0, p.y + 0.0}); // no -0.0
  }
  return all;
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

} // namespace

std::vector<std::uint32_t> cut_by_rings(PlaneTriangulation& plane,
                                        const std::vector<BoundaryRing>& rings,
                                        const std::vector<std::uint32_t>& breaklines,
                                        std::vector<double>& heights_m) {
  const auto places = places_of(rings);
  const auto ordered = in_order(places);
  if (ordered.empty()) return {};

  // The hull first: ring vertices beyond it must not change what is within. With them in, all rings
  // are within the new hull.
  std::vector<std::uint32_t> fixed = add_lines(plane, plane.hull_edges());
  for (const Vec2 place : ordered)
    if (plane.around(place).empty()) insert(plane, place, heights_m);
  // Then triangles that will be cut, so that they are split and nothing else.
  const auto along = add_lines(plane, edges_along(plane, places, heights_m));
  fixed.insert(fixed.end(), along.begin(), along.end());
  for (const Vec2 place : ordered) insert(plane, place, heights_m);

  std::vector<Edge> edges;
  for (const auto& ring : places) {
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

} // namespace orograph
