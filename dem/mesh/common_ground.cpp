// SPDX-License-Identifier: GPL-3.0-or-later
// One triangle is cut down by the other's three sides (Sutherland and Hodgman 1974). Each edge of
// what is left knows which edge of a triangle it is part of.
#include "dem/mesh/common_ground.hpp"

#include "dem/mesh/neighbours.hpp"
#include "dem/mesh/orientation.hpp"

#include <algorithm>

namespace orograph {
namespace {

struct Corner {
  Vec2 at;
  TriangleSide edge; ///< which the edge from here to the next corner is part of
};
using Polygon = std::vector<Corner>;

Vec2 plan(const Tin& tin, std::uint32_t vertex) {
  return {tin.vertices_m[vertex].x, tin.vertices_m[vertex].y};
}

Polygon polygon_of(const Tin& tin, std::uint32_t triangle) {
  Polygon polygon;
  for (std::uint32_t k = 0; k < 3; ++k)
    polygon.push_back({plan(tin, ends_of(tin.triangles[triangle], k)[0]), {triangle, k}});
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
  const Vec2 p = plan(tin, ends[0]), q = plan(tin, ends[1]);
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
    return tin.vertices_m[v].z - height_on(tin, plane, plan(tin, v));
  };
  const double low = above(ends[0]), high = above(ends[1]);
  if (!((low < 0 && high > 0) || (low > 0 && high < 0))) return std::nullopt;
  const Vec2 from = plan(tin, ends[0]), to = plan(tin, ends[1]);
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
