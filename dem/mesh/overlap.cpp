// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/mesh/overlap.hpp"

#include "dem/mesh/orientation.hpp"
#include "dem/mesh/tin_index.hpp"

#include <algorithm>

namespace orograph {
namespace {

using Corners = std::array<Vec2, 3>;

Corners corners(const Tin& tin, std::uint32_t triangle) {
  Corners at;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3& vertex = tin.vertices_m[tin.triangles[triangle][k]];
    at[k] = {vertex.x, vertex.y};
  }
  return at;
}

Box2 box_of(const Corners& corners) {
  Box2 box;
  for (const Vec2 p : corners) box.include(p);
  return box;
}

// One of a's edges has all of b on its outer side or on it.
bool an_edge_parts(const Corners& a, const Corners& b) {
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec2 p = a[k], q = a[(k + 1) % 3];
    if (std::all_of(b.begin(), b.end(), [&](Vec2 c) { return orientation(p, q, c) <= 0; }))
      return true;
  }
  return false;
}

// Two convex polygons whose insides don't meet are parted by the line of an edge of one.
bool overlap(const Corners& a, const Corners& b) {
  const Box2 box_a = box_of(a), box_b = box_of(b);
  if (box_a.high.x <= box_b.low.x || box_b.high.x <= box_a.low.x || box_a.high.y <= box_b.low.y ||
      box_b.high.y <= box_a.low.y)
    return false;
  return !an_edge_parts(a, b) && !an_edge_parts(b, a);
}

std::vector<bool> walls_of(const Tin& tin) {
  std::vector<bool> walls(tin.triangles.size());
  for (std::uint32_t t = 0; t < tin.triangles.size(); ++t) walls[t] = is_wall(tin, t);
  return walls;
}

} // namespace

bool is_wall(const Tin& tin, std::uint32_t triangle) {
  const auto& [a, b, c] = tin.triangles[triangle];
  return plan_orientation(tin.vertices_m[a], tin.vertices_m[b], tin.vertices_m[c]) == 0;
}

bool overlap(const Tin& tin, std::uint32_t a, std::uint32_t b) {
  return overlap(corners(tin, a), corners(tin, b));
}

// How many triangles cover a place changes only across edges that have no triangle, or a wall, on
// the other side. So where any ground is covered twice there is such an edge at its rim, whose
// triangle overlaps another: only those triangles need to be looked at.
std::optional<TrianglePair> first_overlap(const Tin& tin) {
  const std::vector<bool> walls = walls_of(tin);
  const TinIndex index(tin);
  std::vector<std::uint32_t> near;
  for (std::uint32_t t = 0; t < tin.triangles.size(); ++t) {
    const auto& others = tin.neighbours[t];
    if (walls[t] || std::none_of(others.begin(), others.end(),
                                 [&](std::uint32_t n) { return n == kNoTriangle || walls[n]; }))
      continue;
    const Corners at = corners(tin, t);
    index.meeting(box_of(at), near);
    for (const std::uint32_t other : near)
      if (other != t && !walls[other] && overlap(at, corners(tin, other)))
        return TrianglePair{std::min(t, other), std::max(t, other)};
  }
  return std::nullopt;
}

std::vector<TrianglePair> all_overlaps(const Tin& tin) {
  const std::vector<bool> walls = walls_of(tin);
  const TinIndex index(tin);
  std::vector<TrianglePair> pairs;
  std::vector<std::uint32_t> near;
  for (std::uint32_t t = 0; t < tin.triangles.size(); ++t) {
    if (walls[t]) continue;
    const Corners at = corners(tin, t);
    index.meeting(box_of(at), near);
    for (auto other = std::upper_bound(near.begin(), near.end(), t); other != near.end(); ++other)
      if (!walls[*other] && overlap(at, corners(tin, *other))) pairs.push_back({t, *other});
  }
  return pairs;
}

} // namespace orograph
