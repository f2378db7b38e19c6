// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/dem/mesh/whole_triangles.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace orograph {
namespace {

using Kind = TinFault::Kind;

WholePoint lowest_terms(WholePoint p) {
  const auto divisor = [](Whole a, Whole b) {
    if (a < 0) a = -a;
    if (b < 0) b = -b;
    while (b != 0) a = std::exchange(b, a % b);
    return a;
  };
  const Whole d = divisor(divisor(p.x, p.y), p.w) * (p.w < 0 ? -1 : 1);
  return {p.x / d, p.y / d, p.w / d};
}

Whole whole(double value) {
  return static_cast<Whole>(value);
}

bool at_one_point(const Vec3& a, const Vec3& b) {
  return a.x == b.x && a.y == b.y && a.z == b.z;
}

void add_triangle_faults(const Tin& tin, std::size_t t, std::set<Kind>& faults) {
  const Vec3 a = tin.vertices_m[tin.triangles[t][0]], b = tin.vertices_m[tin.triangles[t][1]],
             c = tin.vertices_m[tin.triangles[t][2]];
  if (at_one_point(a, b) || at_one_point(b, c) || at_one_point(c, a))
    faults.insert(Kind::repeated_vertex);
  // Whole numbers below 2^26 are exact in doubles here.
  const Vec3 normal = cross(b - a, c - a);
  if (normal == Vec3{}) faults.insert(Kind::no_area);
  if (normal.z < 0) faults.insert(Kind::turned_over);
}

} // namespace

Whole area(const WholePoint& a, const WholePoint& b, const WholePoint& c) {
  return a.x * (b.y * c.w - c.y * b.w) - a.y * (b.x * c.w - c.x * b.w) +
         a.w * (b.x * c.y - c.x * b.y);
}

bool share_ground(const std::array<WholePoint, 3>& a, const std::array<WholePoint, 3>& b) {
  std::vector<WholePoint> rest(a.begin(), a.end());
  for (std::size_t k = 0; k < 3; ++k) {
    const WholePoint &p = b[k], &q = b[(k + 1) % 3];
    std::vector<WholePoint> inner;
    for (std::size_t i = 0; i < rest.size(); ++i) {
      const WholePoint &r = rest[i], &s = rest[(i + 1) % rest.size()];
      const Whole dr = area(p, q, r), ds = area(p, q, s);
      if (dr >= 0) inner.push_back(r);
      if ((dr < 0 && ds > 0) || (dr > 0 && ds < 0))
        inner.push_back(
            lowest_terms({r.x * ds - s.x * dr, r.y * ds - s.y * dr, r.w * ds - s.w * dr}));
    }
    rest = std::move(inner);
  }
  for (std::size_t i = 2; i < rest.size(); ++i)
    if (area(rest[0], rest[i - 1], rest[i]) != 0) return true;
  return false;
}

std::array<WholePoint, 3> seen_from_above(const Tin& tin, std::size_t triangle) {
  std::array<WholePoint, 3> at;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3& v = tin.vertices_m[tin.triangles[triangle][k]];
    at[k] = {whole(v.x), whole(v.y)};
  }
  return at;
}

std::set<Kind> faults_by_definition(const Tin& tin) {
  std::set<Kind> faults;
  const std::size_t count = tin.triangles.size();
  if (count == 0) faults.insert(Kind::no_triangles);
  if (tin.neighbours.size() != count) faults.insert(Kind::bad_sizes);
  for (const auto& triangle : tin.triangles)
    for (const std::uint32_t v : triangle)
      if (v >= tin.vertices_m.size()) faults.insert(Kind::bad_index);
  for (const auto& neighbours : tin.neighbours)
    for (const std::uint32_t n : neighbours)
      if (n != kNoTriangle && n >= count) faults.insert(Kind::bad_index);
  for (const Vec3& v : tin.vertices_m)
    if (!std::isfinite(v.x + v.y + v.z)) faults.insert(Kind::not_finite);
  if (!faults.empty()) return faults;

  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::uint32_t>> along;
  for (std::uint32_t t = 0; t < count; ++t) {
    add_triangle_faults(tin, t, faults);
    for (std::size_t k = 0; k < 3; ++k)
      along[{tin.triangles[t][(k + 1) % 3], tin.triangles[t][(k + 2) % 3]}].push_back(t);
  }
  for (const auto& [edge, triangles] : along) {
    const auto back = along.find({edge.second, edge.first});
    const std::size_t others = back == along.end() ? 0 : back->second.size();
    if (triangles.size() > 1) faults.insert(Kind::edge_runs_twice);
    if (triangles.size() + others > 2) faults.insert(Kind::edge_of_three);
  }
  if (!faults.empty()) return faults;

  for (std::uint32_t t = 0; t < count; ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto back = along.find({tin.triangles[t][(k + 2) % 3], tin.triangles[t][(k + 1) % 3]});
      const std::uint32_t across = back == along.end() ? kNoTriangle : back->second.front();
      if (tin.neighbours[t][k] != across) faults.insert(Kind::neighbours_disagree);
    }
  for (std::size_t t = 0; t < count; ++t)
    for (std::size_t other = 0; other < t; ++other) {
      const auto a = seen_from_above(tin, t), b = seen_from_above(tin, other);
      if (area(a[0], a[1], a[2]) > 0 && area(b[0], b[1], b[2]) > 0 && share_ground(a, b))
        faults.insert(Kind::overlap);
    }
  return faults;
}

} // namespace orograph
