// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/plan_area.hpp"
#include "profiles/level_ground.hpp"
#include "profiles/tin_edges.hpp"

#include <algorithm>

namespace orograph {
namespace {

// A share of the TIN's ground: 45 mm² of an A4 map.
constexpr double kSmallestWater = 1e-3;

bool is_level(const Tin& tin, std::size_t t) {
  const auto& [a, b, c] = tin.triangles[t];
  return tin.vertices_m[a].z == tin.vertices_m[b].z && tin.vertices_m[b].z == tin.vertices_m[c].z;
}

} // namespace

LevelGround find_level_ground(const Tin& tin, double smallest_m2) {
  LevelGround level;
  TriangleSet seen(tin.triangles.size());
  std::vector<std::uint32_t> region;
  for (std::uint32_t first = 0; first < tin.triangles.size(); ++first) {
    if (seen.has(first) || !is_level(tin, first)) continue;
    region.assign(1, first);
    seen.add(first);
    double area_m2 = 0;
    for (std::size_t i = 0; i < region.size(); ++i) {
      area_m2 += plan_area_m2(tin, region[i]);
      for (const std::uint32_t other : tin.neighbours[region[i]])
        if (other != kNoTriangle && !seen.has(other) && is_level(tin, other)) {
          seen.add(other);
          region.push_back(other);
        }
    }
    if (!(area_m2 >= smallest_m2)) continue;
    ++level.regions;
    if (level.triangles.empty()) level.triangles = TriangleSet(tin.triangles.size());
    for (const std::uint32_t t : region) level.triangles.add(t);
  }
  if (level.regions == 0) return level;
  for_each_edge(tin, [&](const TinEdge& e) {
    if (e.left != kNoTriangle && e.right != kNoTriangle &&
        level.triangles.has(e.left) != level.triangles.has(e.right))
      level.shores.push_back(e.edge);
  });
  std::sort(level.shores.begin(), level.shores.end());
  return level;
}

LevelGround find_water(const Tin& tin) {
  return find_level_ground(tin, kSmallestWater * plan_area_m2(tin));
}

} // namespace orograph
