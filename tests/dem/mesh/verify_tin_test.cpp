// SPDX-License-Identifier: GPL-3.0-or-later
// The checker against the promises in whole numbers, on valid TINs and on broken ones.
#include "dem/mesh/verify_tin.hpp"
#include "tests/catch.hpp"
#include "tests/support/made_tin.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace orograph::verify_tin_test {
namespace {

using Kind = TinFault::Kind;

// What a Tin promises, by definition, for small whole coordinates: everything in whole numbers, all
// pairs of triangles looked at.

using Whole = std::int64_t; ///< enough for coordinates below 200: cut points are in lowest terms

// A point of the plane, (x / w, y / w), w > 0.
struct WholePoint {
  Whole x, y, w = 1;
};

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

// Twice the area of a, b, c, times the product of their w.
Whole area(const WholePoint& a, const WholePoint& b, const WholePoint& c) {
  return a.x * (b.y * c.w - c.y * b.w) - a.y * (b.x * c.w - c.x * b.w) +
         a.w * (b.x * c.y - c.x * b.y);
}

// The insides of two counterclockwise triangles meet: one cut down by the other's edges has an
// area left.
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

// The triangle seen from above. REQUIRES whole coordinates below 200.
std::array<WholePoint, 3> seen_from_above(const Tin& tin, std::size_t triangle) {
  std::array<WholePoint, 3> at;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3& v = tin.vertices_m[tin.triangles[triangle][k]];
    at[k] = {whole(v.x), whole(v.y)};
  }
  return at;
}

// All kinds of fault that the Tin has. Where indices are wrong or coordinates aren't finite, only
// that.
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

MadeTin any_whole(Random& random) {
  MadeTin wanted;
  wanted.columns = random.whole(2, 7);
  wanted.rows = random.whole(2, 7);
  wanted.moved = random.pick({0.0, 0.2});
  wanted.high_m = random.pick({0.0, 4.0, 50.0});
  wanted.whole = true;
  wanted.missing = random.pick({0.0, 0.1, 0.5});
  wanted.walls = random.pick({0.0, 0.5});
  wanted.shuffled = random.chance(0.5);
  return wanted;
}

std::uint32_t any_of(Random& random, std::size_t count) {
  return static_cast<std::uint32_t>(random.whole(0, static_cast<int>(count) - 1));
}

/// Does one thing to the Tin that may break it.
void tamper(Random& random, Tin& tin) {
  const auto vertex = [&] { return any_of(random, tin.vertices_m.size()); };
  const auto add_vertex = [&](Vec3 at) {
    tin.vertices_m.push_back(at);
    return static_cast<std::uint32_t>(tin.vertices_m.size() - 1);
  };
  const auto place = [&](Vec3 near) {
    return Vec3{near.x + random.whole(-15, 15), near.y + random.whole(-15, 15),
                near.z + random.whole(-1, 1)};
  };
  auto& triangle = tin.triangles[any_of(random, tin.triangles.size())];
  const auto k = static_cast<std::size_t>(random.whole(0, 2));
  bool neighbours_follow = true;
  switch (random.whole(0, 13)) {
  case 0:
    std::swap(triangle[0], triangle[1]);
    break;
  case 1:
    triangle[k] = vertex();
    break;
  case 2:
    tin.vertices_m[triangle[k]] = place(tin.vertices_m[triangle[k]]);
    break;
  case 3:
    tin.triangles.push_back(triangle);
    break;
  case 4:
    tin.triangles.push_back({triangle[0], triangle[2], triangle[1]});
    break;
  case 5: { // a third on an edge, or a second
    const std::uint32_t v = add_vertex(place(tin.vertices_m[triangle[k]]));
    tin.triangles.push_back({triangle[(k + 1) % 3], triangle[k], v});
    break;
  }
  case 6: { // upright on an edge
    const std::uint32_t v = add_vertex(tin.vertices_m[triangle[k]] + Vec3{0, 0, 7});
    tin.triangles.push_back({triangle[(k + 1) % 3], triangle[k], v});
    break;
  }
  case 7: { // all on one line
    const Vec3 a = tin.vertices_m[triangle[0]], b = tin.vertices_m[triangle[1]];
    tin.triangles.push_back({triangle[1], triangle[0], add_vertex(b + (b - a))});
    break;
  }
  case 8: { // an island, on land or off it
    const Vec3 at = place(tin.vertices_m[vertex()]);
    const std::uint32_t v = add_vertex(at);
    add_vertex(at + Vec3{double(random.whole(1, 9)), 0, 1});
    add_vertex(at + Vec3{0, double(random.whole(1, 9)), 0});
    tin.triangles.push_back({v, v + 1, v + 2});
    break;
  }
  case 9:
    tin.vertices_m[triangle[k]] = tin.vertices_m[triangle[(k + 1) % 3]];
    break;
  case 10: {
    const double wrong = random.pick({std::nan(""), HUGE_VAL, -HUGE_VAL});
    Vec3& at = tin.vertices_m[vertex()];
    (k == 0 ? at.x : k == 1 ? at.y : at.z) = wrong;
    break;
  }
  case 11:
    triangle[k] = static_cast<std::uint32_t>(tin.vertices_m.size()) + (k == 2 ? 0 : 5);
    break;
  case 12: {
    auto& neighbour = tin.neighbours[any_of(random, tin.neighbours.size())][k];
    neighbour = random.pick({kNoTriangle, any_of(random, tin.triangles.size()),
                             static_cast<std::uint32_t>(tin.triangles.size())});
    neighbours_follow = false;
    break;
  }
  default:
    if (k == 0) tin.neighbours.pop_back();
    if (k == 1) tin.neighbours.emplace_back();
    if (k == 2) tin = {};
    neighbours_follow = false;
  }
  if (neighbours_follow) tin.neighbours = neighbours_by_sorting(tin.triangles);
}

bool agrees(const Tin& tin, std::map<Kind, int>& seen) {
  const auto found = verify(tin);
  const auto right = faults_by_definition(tin);
  if (found) ++seen[found->kind];
  INFO((found ? found->what : "valid"));
  if (found) CHECK_FALSE(found->what.empty());
  return found ? right.contains(found->kind) : right.empty();
}

Tin tin_of(std::vector<Vec3> vertices, std::vector<std::array<std::uint32_t, 3>> triangles) {
  return {std::move(vertices), triangles, neighbours_by_sorting(triangles)};
}

} // namespace

TEST_CASE("a TIN is valid exactly where all pairs of triangles say so") {
  std::map<Kind, int> seen;
  int valid = 0, still_valid = 0;
  for (std::uint64_t seed = 1; seed <= last_seed(3000); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    Tin tin = made_tin(random, any_whole(random));
    REQUIRE(agrees(tin, seen));
    if (tin.triangles.empty()) continue;
    REQUIRE_FALSE(verify(tin));
    ++valid;
    tamper(random, tin);
    REQUIRE(agrees(tin, seen));
    still_valid += verify(tin) ? 0 : 1;
  }
  CHECK(valid > enough(2500));
  CHECK(still_valid > enough(100));
  for (int kind = 0; kind <= static_cast<int>(Kind::overlap); ++kind) {
    CAPTURE(kind);
    CHECK(seen[static_cast<Kind>(kind)] > enough(20));
  }
}

TEST_CASE("a few triangles on a small lattice, in every position") {
  std::map<Kind, int> seen;
  int valid = 0;
  for (std::uint64_t seed = 1; seed <= last_seed(30000); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    const int most = random.pick({2, 4, 6});
    std::vector<Vec3> vertices;
    for (int i = random.whole(3, 9); i > 0; --i)
      vertices.push_back({double(random.whole(0, most)), double(random.whole(0, most)),
                          double(random.whole(0, 1))});
    std::vector<std::array<std::uint32_t, 3>> triangles;
    for (int i = random.whole(1, 4); i > 0; --i) {
      std::array<std::uint32_t, 3> t;
      for (auto& v : t) v = any_of(random, vertices.size());
      const Vec3 normal = cross(vertices[t[1]] - vertices[t[0]], vertices[t[2]] - vertices[t[0]]);
      if (normal.z < 0) std::swap(t[0], t[1]);
      if (normal != Vec3{}) triangles.push_back(t);
    }
    const Tin tin = tin_of(vertices, triangles);
    REQUIRE(agrees(tin, seen));
    valid += verify(tin) ? 0 : 1;
  }
  CHECK(valid > enough(5000));
  CHECK(seen[Kind::overlap] > enough(2000));
  CHECK(seen[Kind::edge_runs_twice] > enough(100));
}

TEST_CASE("a sheet over the midst of another one, with walls all round it, overlaps it") {
  // No triangle that is part of the overlap has a free edge.
  Random random(1);
  MadeTin wanted;
  wanted.moved = 0;
  wanted.high_m = 0;
  Tin tin = made_tin(random, wanted);
  const auto first = static_cast<std::uint32_t>(tin.vertices_m.size());
  for (const double height : {5.0, 1.0})
    for (const Vec2 p : {Vec2{23, 23}, Vec2{27, 23}, Vec2{27, 27}, Vec2{23, 27}})
      tin.vertices_m.push_back({p.x, p.y, height});
  for (std::array<std::uint32_t, 3> t : {std::array{0U, 1U, 2U},
                                         {0, 2, 3},
                                         {4, 5, 1},
                                         {4, 1, 0},
                                         {5, 6, 2},
                                         {5, 2, 1},
                                         {6, 7, 3},
                                         {6, 3, 2},
                                         {7, 4, 0},
                                         {7, 0, 3}}) {
    for (std::uint32_t& v : t) v += first;
    tin.triangles.push_back(t);
  }
  tin.neighbours = neighbours_by_sorting(tin.triangles);
  REQUIRE(verify(tin));
  CHECK(verify(tin)->kind == Kind::overlap);
  for (std::uint32_t v = first; v < first + 8; ++v) tin.vertices_m[v].x += 40; // beside it
  CHECK_FALSE(verify(tin));
}

TEST_CASE("the last bit decides whether triangles overlap") {
  // Two triangles on a common line y = s x from both sides, with different vertices; then one is
  // moved by an ulp.
  for (const double scale : {1.0, 1e150, 1e300, 1e-150, 1e-300, 1e-310}) {
    CAPTURE(scale);
    const Tin apart = tin_of({{0, 0, 0},
                              {3 * scale, 3 * scale, 0},
                              {0, 3 * scale, 0},
                              {scale, scale, 0},
                              {4 * scale, 0, 0},
                              {2 * scale, 2 * scale, 0}},
                             {{0, 1, 2}, {3, 4, 5}});
    CHECK_FALSE(verify(apart));
    Tin over = apart;
    over.vertices_m[3].y = std::nextafter(scale, HUGE_VAL);
    REQUIRE(verify(over));
    CHECK(verify(over)->kind == Kind::overlap);
    Tin off = apart;
    off.vertices_m[3].y = std::nextafter(scale, 0);
    CHECK_FALSE(verify(off));
  }
}

TEST_CASE("walls only: one that fits its neighbour is valid, one turned the other way isn't") {
  std::vector<Vec3> vertices{{0, 0, 0}, {5, 0, 0}, {5, 0, 4}, {0, 0, 4}};
  CHECK_FALSE(verify(tin_of(vertices, {{0, 1, 2}, {0, 2, 3}})));
  const auto fault = verify(tin_of(vertices, {{0, 1, 2}, {0, 3, 2}}));
  REQUIRE(fault);
  CHECK(fault->kind == Kind::edge_runs_twice);
}

} // namespace orograph::verify_tin_test
