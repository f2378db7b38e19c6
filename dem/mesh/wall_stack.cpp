// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/mesh/wall_stack.hpp"

#include "dem/mesh/edge_points.hpp"
#include "dem/mesh/orientation.hpp"
#include "dem/mesh/overlap.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace orograph {

WallStack stack_of(const Tin& tin, std::uint32_t wall) {
  WallStack stack;
  std::set<std::uint32_t> seen{wall};
  stack.walls.push_back(wall);
  for (std::size_t i = 0; i < stack.walls.size(); ++i) {
    const std::uint32_t t = stack.walls[i];
    for (std::uint32_t k = 0; k < 3; ++k) {
      const PlanEdge edge = edge_of(tin.triangles[t], k);
      if (is_upright(tin, edge)) continue;
      stack.edges.push_back(edge);
      const std::uint32_t other = tin.neighbours[t][k];
      if (other == kNoTriangle || seen.contains(other)) continue;
      if (is_wall(tin, other)) {
        seen.insert(other);
        stack.walls.push_back(other);
        continue;
      }
      for (const std::uint32_t v : tin.triangles[other])
        if (v != edge[0] && v != edge[1]) stack.grounds.push_back({other, edge, v});
    }
  }
  std::sort(stack.edges.begin(), stack.edges.end());
  stack.edges.erase(std::unique(stack.edges.begin(), stack.edges.end()), stack.edges.end());
  const Vec2 by = plan(tin, stack.edges[0][1]) - plan(tin, stack.edges[0][0]);
  stack.along_x = std::abs(by.x) >= std::abs(by.y);
  for (const PlanEdge& edge : stack.edges)
    for (const std::uint32_t v : edge) stack.columns[stack.along(tin, v)] = plan(tin, v);
  return stack;
}

double WallStack::add_column(const Tin& tin, const PlanEdge& edge, double share) {
  const Vec3 at = point_on(tin, edge, share);
  const double wanted = along_x ? at.x : at.y, reach_m = rounding_reach_m(tin, edge);
  const auto not_an_end = [&](double column) {
    return column != along(tin, edge[0]) && column != along(tin, edge[1]);
  };
  const double* nearest = nullptr;
  for (auto it = columns.lower_bound(wanted - reach_m);
       it != columns.end() && it->first <= wanted + reach_m; ++it)
    if (not_an_end(it->first) &&
        (nearest == nullptr || std::abs(it->first - wanted) < std::abs(*nearest - wanted)))
      nearest = &it->first;
  if (nearest != nullptr) return *nearest;
  columns[wanted] = {at.x, at.y};
  new_columns.push_back(wanted);
  return wanted;
}

void WallStack::round_to_ground(const Tin& tin) {
  for (const double column : new_columns) {
    Vec2& place = columns[column];
    bool left = false, right = false; // of the line the way it grows
    Vec2 from, to;
    for (const BesideWall& ground : grounds) {
      Vec2 first = plan(tin, ground.edge[0]), last = plan(tin, ground.edge[1]);
      double begin = along(tin, ground.edge[0]), end = along(tin, ground.edge[1]);
      if (begin > end) std::swap(first, last), std::swap(begin, end);
      if (column <= begin || column >= end) continue;
      (orientation(first, last, plan(tin, ground.apex)) > 0 ? left : right) = true;
      from = first, to = last;
    }
    if (left && !right) place = to_inner_side(from, to, place);
    if (right && !left) place = to_inner_side(to, from, place);
  }
}

std::vector<WallStack::Column> WallStack::between(double one, double other) const {
  const auto [low, high] = std::minmax({one, other});
  std::vector<Column> found;
  for (auto it = columns.upper_bound(low); it != columns.end() && it->first < high; ++it)
    found.push_back({it->first, it->second});
  return found;
}

} // namespace orograph
