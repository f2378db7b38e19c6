// SPDX-License-Identifier: GPL-3.0-or-later
// Points on the edges of a Tin, and their rounding.
#pragma once

#include "dem/mesh/half_space.hpp"
#include "dem/mesh/orientation.hpp"
#include "dem/mesh/piece_vertices.hpp"
#include "dem/tin.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace orograph {

inline Vec2 plan(const Tin& tin, std::uint32_t vertex) {
  return {tin.vertices_m[vertex].x, tin.vertices_m[vertex].y};
}
inline bool is_upright(const Tin& tin, const PlanEdge& edge) {
  return plan(tin, edge[0]) == plan(tin, edge[1]);
}
/// The greater of its extents east and north.
inline double plan_length_m(const Tin& tin, const PlanEdge& edge) {
  const Vec2 by = plan(tin, edge[1]) - plan(tin, edge[0]);
  return std::max(std::abs(by.x), std::abs(by.y));
}
/// What is nearer along an edge, seen from above, is one place.
inline double rounding_reach_m(const Tin& tin, const PlanEdge& edge) {
  double greatest_m = 0;
  for (const std::uint32_t v : edge)
    greatest_m = std::max({greatest_m, std::abs(plan(tin, v).x), std::abs(plan(tin, v).y)});
  return kRoundingsOnPlane * std::numeric_limits<double>::epsilon() * greatest_m;
}

/// Reckoned from the edge's lower vertex.
inline Vec3 point_on(const Tin& tin, const PlanEdge& edge, double share) {
  const Vec3 &a = tin.vertices_m[edge[0]], &b = tin.vertices_m[edge[1]];
  return a + share * (b - a);
}

/// A point near the line from one point to another, moved by as few roundings of the greatest
/// coordinate as put it on the line or to the left of it, exactly.
inline Vec2 to_inner_side(Vec2 from, Vec2 to, Vec2 p) {
  const Vec2 by = to - from;
  double step_m = std::numeric_limits<double>::epsilon() / 2 *
                  std::max({std::abs(from.x), std::abs(from.y), std::abs(to.x), std::abs(to.y)});
  for (; orientation(from, to, p) < 0; step_m *= 2) {
    if (std::abs(by.x) >= std::abs(by.y))
      p.y += by.x > 0 ? step_m : -step_m;
    else
      p.x += by.y > 0 ? -step_m : step_m;
  }
  return p;
}

} // namespace orograph
