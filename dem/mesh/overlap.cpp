// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/mesh/overlap.hpp"

#include "dem/mesh/neighbours.hpp"
#include "dem/mesh/tin_index.hpp"
#include "dem/mesh/walls.hpp"
#include "dem/triangulate/orientation.hpp"
#include "geometry/on_all_cores.hpp"

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

struct Corner {
  Vec2 at;
  TriangleSide edge; ///< which the edge from here to the next corner is part of
};
using Polygon = std::vector<Corner>;

Polygon polygon_of(const Tin& tin, std::uint32_t triangle) {
  Polygon polygon;
  for (std::uint32_t k = 0; k < 3; ++k)
    polygon.push_back({plan_m(tin, ends_of(tin.triangles[triangle], k)[0]), {triangle, k}});
  return polygon;
}

double area_of(const Polygon& polygon) {
  double twice = 0;
  for (std::size_t i = 2; i < polygon.size(); ++i)
    twice += cross(polygon[i - 1].at - polygon[0].at, polygon[i].at - polygon[0].at);
  return twice / 2;
}

// What is left of the polygon to the left of `side`.
Polygon cut_down(const Polygon& polygon, const Tin& tin, TriangleSide side) {
  const auto ends = ends_of(tin.triangles[side.triangle], side.side);
  const Vec2 p = plan_m(tin, ends[0]), q = plan_m(tin, ends[1]);
  const auto inner = [&](Vec2 at) { return orientation(p, q, at); };
  Polygon left;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Corner &from = polygon[i], &to = polygon[(i + 1) % polygon.size()];
    const int before = inner(from.at), after = inner(to.at);
    if (before > 0 || (before == 0 && after > 0)) left.push_back(from);
    if (before == 0 && after <= 0) left.push_back({from.at, side}); // the cut runs on from here
    if (before * after < 0) {
      const double f = cross(q - p, from.at - p), t = cross(q - p, to.at - p);
      const Vec2 at = from.at + f / (f - t) * (to.at - from.at);
      left.push_back({at, before > 0 ? side : from.edge});
    }
  }
  return left;
}

// Where the edge's height is the plane's, reckoned along the whole edge so that neighbours agree.
std::optional<PiercedEdge> pierced_edge(const Tin& tin, TriangleSide side, std::uint32_t plane) {
  auto ends = ends_of(tin.triangles[side.triangle], side.side);
  if (ends[0] > ends[1]) std::swap(ends[0], ends[1]);
  const auto above = [&](std::uint32_t v) {
    return tin.vertices_m[v].z - height_on(tin, plane, plan_m(tin, v));
  };
  const double low = above(ends[0]), high = above(ends[1]);
  if (!((low < 0 && high > 0) || (low > 0 && high < 0))) return std::nullopt;
  const Vec2 from = plan_m(tin, ends[0]), to = plan_m(tin, ends[1]);
  return PiercedEdge{ends, from + low / (low - high) * (to - from)};
}

std::optional<std::array<Vec2, 2>> farthest_apart(const std::vector<Vec2>& points) {
  std::optional<std::array<Vec2, 2>> pair;
  double most = 0;
  for (const Vec2 a : points)
    for (const Vec2 b : points)
      if (length(b - a) > most) {
        most = length(b - a);
        pair = {a, b};
      }
  return pair;
}

} // namespace

bool overlap(const Tin& tin, std::uint32_t a, std::uint32_t b) {
  return overlap(corners(tin, a), corners(tin, b));
}

// How many triangles cover a place changes only across edges that have no triangle, or a wall, on
// the other side. So where any ground is covered twice there is such an edge at its rim, whose
// triangle overlaps another: only those triangles need to be looked at.
std::optional<TrianglePair> first_overlap(const Tin& tin) {
  const std::vector<std::uint8_t> walls = are_walls(tin);
  const TinIndex index(tin);
  std::vector<std::uint32_t> near;
  for (std::uint32_t t = 0; t < tin.triangles.size(); ++t) {
    throw_if_stopped(t);
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
  const std::vector<std::uint8_t> walls = are_walls(tin);
  const TinIndex index(tin);
  std::vector<TrianglePair> pairs;
  std::vector<std::uint32_t> near;
  for (std::uint32_t t = 0; t < tin.triangles.size(); ++t) {
    throw_if_stopped(t);
    if (walls[t]) continue;
    const Corners at = corners(tin, t);
    index.meeting(box_of(at), near);
    for (auto other = std::upper_bound(near.begin(), near.end(), t); other != near.end(); ++other)
      if (!walls[*other] && overlap(at, corners(tin, *other))) pairs.push_back({t, *other});
  }
  return pairs;
}

double height_on(const Tin& tin, std::uint32_t triangle, Vec2 at) {
  const auto& [i, j, k] = tin.triangles[triangle];
  const Vec3 &a = tin.vertices_m[i], &b = tin.vertices_m[j], &c = tin.vertices_m[k];
  const Vec2 ab{b.x - a.x, b.y - a.y}, ac{c.x - a.x, c.y - a.y}, p{at.x - a.x, at.y - a.y};
  const double all = cross(ab, ac);
  if (all == 0) { // a needle whose area rounds to nothing: along its longer edge from a
    const bool to_b = dot(ab, ab) >= dot(ac, ac);
    const Vec2 along = to_b ? ab : ac;
    return a.z + dot(p, along) / dot(along, along) * ((to_b ? b.z : c.z) - a.z);
  }
  return a.z + cross(p, ac) / all * (b.z - a.z) + cross(ab, p) / all * (c.z - a.z);
}

double area_m2(const Tin& tin, std::uint32_t triangle) {
  return area_of(polygon_of(tin, triangle));
}

// One triangle is cut down by the other's three sides (Sutherland and Hodgman 1974). Each edge of
// what is left knows which edge of a triangle it is part of.
CommonGround common_ground(const Tin& tin, std::uint32_t a, std::uint32_t b, double tolerance_m) {
  Polygon polygon = polygon_of(tin, a);
  for (std::uint32_t k = 0; k < 3; ++k) polygon = cut_down(polygon, tin, {b, k});
  CommonGround common;
  common.area_m2 = area_of(polygon);
  std::vector<double> above;
  for (const Corner& corner : polygon) {
    const double height = height_on(tin, a, corner.at) - height_on(tin, b, corner.at);
    above.push_back(std::abs(height) <= tolerance_m ? 0 : height);
  }
  if (polygon.empty()) return common; // rounded away
  common.least_m = *std::min_element(above.begin(), above.end());
  common.greatest_m = *std::max_element(above.begin(), above.end());
  if (common.least_m >= 0 || common.greatest_m <= 0) return common;

  // The line runs between two places on the polygon's rim.
  std::vector<Vec2> ends;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const std::size_t next = (i + 1) % polygon.size();
    if (above[i] == 0) ends.push_back(polygon[i].at);
    if (above[i] * above[next] >= 0) continue;
    const TriangleSide side = polygon[i].edge;
    if (auto pierced = pierced_edge(tin, side, side.triangle == a ? b : a)) {
      ends.push_back(pierced->at);
      common.pierced.push_back(*pierced);
    } else {
      ends.push_back(polygon[i].at +
                     above[i] / (above[i] - above[next]) * (polygon[next].at - polygon[i].at));
    }
  }
  common.pierce = farthest_apart(ends); // corners may be there twice, all but rounding
  return common;
}

} // namespace orograph
