// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/triangulate/peel_border.hpp"

#include "dem/tin.hpp"

#include <algorithm>
#include <limits>

namespace orograph {
namespace {

double longest_edge_m(const PlaneMesh& mesh, const std::vector<Vec2>& places,
                      std::size_t triangle) {
  const auto& [a, b, c] = mesh.triangles[triangle];
  return std::max({length(places[b] - places[a]), length(places[c] - places[b]),
                   length(places[a] - places[c])});
}

} // namespace

std::uint64_t peel_border(const PlaneMesh& mesh, const std::vector<Vec2>& places, double max_edge_m,
                          std::vector<char>& kept) {
  std::uint64_t gone = 0;
  std::vector<std::uint32_t> open;
  const auto at_border = [&](std::uint32_t t) {
    if (!kept[t] || longest_edge_m(mesh, places, t) <= max_edge_m) return;
    kept[t] = 0;
    ++gone;
    open.push_back(t);
  };
  const auto is_border = [&](std::uint32_t beyond) {
    return beyond == kNoTriangle || !kept[beyond];
  };
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
    if (std::any_of(mesh.neighbours[t].begin(), mesh.neighbours[t].end(), is_border)) at_border(t);
  while (!open.empty()) {
    const std::uint32_t t = open.back();
    open.pop_back();
    for (const std::uint32_t next : mesh.neighbours[t])
      if (next != kNoTriangle) at_border(next);
  }
  return gone;
}

double least_max_edge_m(const PlaneMesh& mesh, const std::vector<Vec2>& places,
                        const std::vector<char>& kept) {
  // A triangle whose edges are short enough is never taken; with none, all are in the end.
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    if (kept[t]) least = std::min(least, longest_edge_m(mesh, places, t));
  return least;
}

} // namespace orograph
