// SPDX-License-Identifier: GPL-3.0-or-later
// From the outside inwards: crossing an edge that an odd number of rings run along changes sides.
#include "dem/triangulate/inside_rings.hpp"

#include "dem/tin.hpp"
#include "dem/triangulate/plane_lines.hpp"

#include <algorithm>

namespace orograph {
namespace {

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
