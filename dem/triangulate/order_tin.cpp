// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/triangulate/order_tin.hpp"

#include "dem/triangulate/hilbert_order.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

namespace orograph {
namespace {

// A triangle's new vertices from the first on, and where it was.
struct Placed {
  std::array<std::uint32_t, 3> vertices;
  std::uint32_t before;
  std::uint32_t turned; ///< its corner k was (k + turned) % 3
};

// New numbers of the vertices that are used; `tin` gets them in their new order.
std::vector<std::uint32_t> number_vertices(const PlaneMesh& mesh, const std::vector<char>& kept,
                                           const std::vector<Vec2>& places,
                                           const std::vector<double>& heights_m, Tin& tin) {
  std::vector<std::uint32_t> number(places.size(), kNoTriangle), used;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    if (kept[t])
      for (const std::uint32_t v : mesh.triangles[t]) number[v] = 0;
  std::vector<Vec2> used_places;
  for (std::uint32_t v = 0; v < places.size(); ++v)
    if (number[v] == 0) {
      used.push_back(v);
      used_places.push_back(places[v]);
    }
  tin.vertices_m.reserve(used.size());
  for (const std::uint32_t i : hilbert_order(used_places)) {
    number[used[i]] = static_cast<std::uint32_t>(tin.vertices_m.size());
    tin.vertices_m.push_back({used_places[i].x, used_places[i].y, heights_m[used[i]]});
  }
  return number;
}

// In buckets by the first vertex, as there are only a few triangles for each; then each bucket.
std::vector<Placed> in_order(const PlaneMesh& mesh, const std::vector<char>& kept,
                             const std::vector<std::uint32_t>& number, std::size_t vertices) {
  const auto placed = [&](std::uint32_t t) {
    const auto& [a, b, c] = mesh.triangles[t];
    const std::array<std::uint32_t, 3> v{number[a], number[b], number[c]};
    const auto first = static_cast<std::uint32_t>(std::min_element(v.begin(), v.end()) - v.begin());
    return Placed{{v[first], v[(first + 1) % 3], v[(first + 2) % 3]}, t, first};
  };
  std::vector<std::uint32_t> end(vertices + 1, 0);
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
    if (kept[t]) ++end[placed(t).vertices[0] + 1];
  for (std::size_t v = 0; v < vertices; ++v) end[v + 1] += end[v];
  std::vector<Placed> ordered(end.back());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
    if (kept[t]) {
      const Placed here = placed(t);
      ordered[end[here.vertices[0]]++] = here;
    }
  // Each bucket's begin has become its end.
  for (std::size_t v = 0, begin = 0; v < vertices; begin = end[v], ++v)
    std::sort(ordered.begin() + static_cast<std::ptrdiff_t>(begin),
              ordered.begin() + static_cast<std::ptrdiff_t>(end[v]),
              [](const Placed& a, const Placed& b) { return a.vertices < b.vertices; });
  return ordered;
}

} // namespace

Tin order_tin(const PlaneMesh& mesh, const std::vector<char>& kept, const std::vector<Vec2>& places,
              const std::vector<double>& heights_m) {
  Tin tin;
  const auto number = number_vertices(mesh, kept, places, heights_m, tin);
  const auto ordered = in_order(mesh, kept, number, tin.vertices_m.size());
  std::vector<std::uint32_t> now(mesh.triangles.size(), kNoTriangle);
  for (std::uint32_t t = 0; t < ordered.size(); ++t) now[ordered[t].before] = t;
  tin.triangles.reserve(ordered.size());
  tin.neighbours.reserve(ordered.size());
  for (const Placed& triangle : ordered) {
    tin.triangles.push_back(triangle.vertices);
    auto& across = tin.neighbours.emplace_back();
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t before = mesh.neighbours[triangle.before][(k + triangle.turned) % 3];
      across[k] = before == kNoTriangle ? kNoTriangle : now[before];
    }
  }
  return tin;
}

} // namespace orograph
