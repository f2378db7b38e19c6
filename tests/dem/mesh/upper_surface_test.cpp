// SPDX-License-Identifier: GPL-3.0-or-later
// The repaired surface against the highest triangle of the soup at many points.
#include "dem/mesh/tin_from_triangles.hpp"
#include "dem/mesh/verify_tin.hpp"
#include "geometry/box.hpp"
#include "geometry/error.hpp"
#include "tests/catch.hpp"
#include "tests/support/made_tin.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <string>

namespace orograph::upper_surface_test {
namespace {

struct HighestAt {
  std::optional<double> height_m;
  bool close_to_an_edge = false; ///< or to where two heights are equal
  double steepest = 0;           ///< slope of the triangles there
  int layers = 0;
};

/// By a look at every triangle, in either direction.
HighestAt highest_at(const std::vector<Vec3>& points,
                     const std::vector<std::array<std::uint32_t, 3>>& triangles, Vec2 p,
                     double close_m) {
  HighestAt highest;
  for (const auto& triangle : triangles) {
    const Vec3 a = points[triangle[0]], b = points[triangle[1]], c = points[triangle[2]];
    const Vec3 normal = cross(b - a, c - a);
    if (normal.z == 0) continue;
    int inside = 0;
    for (const auto& [from, to] : {std::pair{a, b}, std::pair{b, c}, std::pair{c, a}}) {
      const Vec2 edge{to.x - from.x, to.y - from.y}, off{p.x - from.x, p.y - from.y};
      const double across = cross(edge, off) / length(edge), along = dot(edge, off) / length(edge);
      inside += across * normal.z > 0 ? 1 : 0;
      if (std::abs(across) < close_m && along > -close_m && along < length(edge) + close_m)
        highest.close_to_an_edge = true;
    }
    if (inside < 3) continue;
    const double height = a.z - (normal.x * (p.x - a.x) + normal.y * (p.y - a.y)) / normal.z;
    highest.steepest =
        std::max(highest.steepest, length(Vec2{normal.x, normal.y}) / std::abs(normal.z));
    highest.height_m = std::max(highest.height_m.value_or(height), height);
    ++highest.layers;
  }
  return highest;
}

struct Tried {
  int land = 0, sea = 0, layered = 0;
};

void check_surface(Random& random, const TriangleSoup& soup, const Tin& tin, Tried& tried,
                   double close_m = 1e-9) {
  Box2 box;
  for (const Vec3& p : soup.points_m) box.include({p.x, p.y});
  for (int i = 0; i < 150; ++i) {
    const Vec2 p{random.between(box.low.x, box.high.x), random.between(box.low.y, box.high.y)};
    const HighestAt right = highest_at(soup.points_m, soup.triangles, p, close_m);
    if (right.close_to_an_edge) continue;
    const HighestAt found = highest_at(tin.vertices_m, tin.triangles, p, close_m);
    CAPTURE(p.x, p.y, right.layers, found.layers);
    if (found.close_to_an_edge && found.layers == 0) continue;
    REQUIRE(found.height_m.has_value() == right.height_m.has_value());
    ++(right.height_m ? tried.land : tried.sea);
    if (!right.height_m) continue;
    tried.layered += right.layers > 1 ? 1 : 0;
    REQUIRE(found.layers == 1);
    CAPTURE(*right.height_m, *found.height_m);
    REQUIRE(std::abs(*right.height_m - *found.height_m) <=
            close_m * (1 + right.steepest + found.steepest));
  }
}

TriangleSoup soup_of(const Tin& tin) {
  return {tin.vertices_m, tin.triangles};
}

void add(TriangleSoup& soup, const TriangleSoup& other, Vec3 moved = {}) {
  const auto first = static_cast<std::uint32_t>(soup.points_m.size());
  for (const Vec3& p : other.points_m) soup.points_m.push_back(p + moved);
  for (const auto& [a, b, c] : other.triangles)
    soup.triangles.push_back({first + a, first + b, first + c});
}

TriangleSoup sheet(Random& random) {
  MadeTin wanted;
  wanted.columns = random.whole(2, 6);
  wanted.rows = random.whole(2, 6);
  wanted.step_m = random.pick({7.0, 10.0});
  wanted.moved = random.pick({0.0, 0.2});
  wanted.whole = random.chance(0.6);
  wanted.high_m = random.pick({0.0, 3.0, 30.0});
  wanted.missing = random.pick({0.0, 0.2});
  wanted.walls = random.pick({0.0, 0.4});
  return soup_of(made_tin(random, wanted));
}

Tin repaired(const TriangleSoup& soup, std::vector<std::string>* notes = nullptr) {
  TinFromTriangles found = tin_from_triangles(soup, true, "pile.stl");
  const auto fault = verify(found.tin);
  INFO((fault ? fault->what : ""));
  REQUIRE_FALSE(fault);
  if (notes) *notes = found.notes;
  return found.tin;
}

/// A lattice with walls all round down to a base, closed.
TriangleSoup block(Random& random, int columns, int rows) {
  MadeTin wanted;
  wanted.columns = columns;
  wanted.rows = rows;
  wanted.moved = 0; // the base is a fan about the middle
  TriangleSoup soup = soup_of(made_tin(random, wanted));
  const auto at = [&](int column, int row) {
    return static_cast<std::uint32_t>(row * columns + column);
  };
  std::vector<std::uint32_t> rim;
  for (int c = 0; c + 1 < columns; ++c) rim.push_back(at(c, 0));
  for (int r = 0; r + 1 < rows; ++r) rim.push_back(at(columns - 1, r));
  for (int c = columns - 1; c > 0; --c) rim.push_back(at(c, rows - 1));
  for (int r = rows - 1; r > 0; --r) rim.push_back(at(0, r));
  const auto foot = static_cast<std::uint32_t>(soup.points_m.size());
  const auto count = static_cast<std::uint32_t>(rim.size());
  for (const std::uint32_t v : rim)
    soup.points_m.push_back({soup.points_m[v].x, soup.points_m[v].y, -10});
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t next = (i + 1) % count;
    soup.triangles.push_back({foot + i, foot + next, rim[next]});
    soup.triangles.push_back({foot + i, rim[next], rim[i]});
  }
  soup.points_m.push_back({columns * 5.0 - 5, rows * 5.0 - 5, -10});
  for (std::uint32_t i = 0; i < count; ++i)
    soup.triangles.push_back({foot + (i + 1) % count, foot + i, foot + count});
  return soup;
}

} // namespace

TEST_CASE("sheets in a pile: what is highest is left") {
  Tried tried;
  for (std::uint64_t seed = 1; seed <= last_seed(250); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    TriangleSoup soup = sheet(random);
    for (int sheets = random.whole(1, 3); sheets > 0; --sheets) {
      const double reach = random.pick({0.0, 10.0, 40.0});
      Vec3 moved{random.between(-reach, reach), random.between(-reach, reach),
                 random.pick({0.0, random.between(-10, 10)})};
      if (random.chance(0.5))
        moved = {std::round(moved.x), std::round(moved.y), std::round(moved.z)};
      add(soup, random.chance(0.2) ? soup : sheet(random), moved);
    }
    if (soup.triangles.empty()) continue;
    check_surface(random, soup, repaired(soup), tried);
  }
  CHECK(tried.land > enough(6000));
  CHECK(tried.sea > enough(1000));
  CHECK(tried.layered > enough(3000));
}

TEST_CASE("triangles thrown together at random") {
  Tried tried;
  for (std::uint64_t seed = 1; seed <= last_seed(800); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    TriangleSoup soup;
    const double size = random.pick({4.0, 20.0, 1000.0});
    const bool whole = random.chance(0.6);
    for (int i = random.whole(4, 12); i > 0; --i) {
      Vec3 p{random.between(0, size), random.between(0, size), random.between(0, size)};
      if (whole) p = {std::round(p.x), std::round(p.y), std::round(p.z)};
      soup.points_m.push_back(p);
    }
    const int last = static_cast<int>(soup.points_m.size()) - 1;
    for (int i = random.whole(1, 12); i > 0; --i) {
      std::array<std::uint32_t, 3> t;
      for (auto& v : t) v = static_cast<std::uint32_t>(random.whole(0, last));
      soup.triangles.push_back(t);
    }
    try {
      check_surface(random, soup, repaired(soup), tried, 1e-7);
    } catch (const Error&) { // nothing of area
    }
  }
  CHECK(tried.layered > enough(3000));
}

TEST_CASE("heaps on a small lattice, where much is level and much coincides") {
  Tried tried;
  std::vector<std::uint64_t> seeds{597}; // in which a point comes out twice, an ulp apart
  for (std::uint64_t seed = 25; seed < 25 + last_seed(21); ++seed) seeds.push_back(seed);
  for (const std::uint64_t seed : seeds) {
    Random random(seed);
    INFO("seed " << seed);
    TriangleSoup soup;
    for (int i = random.whole(15, 40); i > 0; --i)
      soup.points_m.push_back(
          {double(random.whole(0, 4)), double(random.whole(0, 4)), double(random.whole(0, 4))});
    const int last = static_cast<int>(soup.points_m.size()) - 1;
    for (int i = random.whole(15, 60); i > 0; --i) {
      std::array<std::uint32_t, 3> t;
      for (auto& v : t) v = static_cast<std::uint32_t>(random.whole(0, last));
      soup.triangles.push_back(t);
    }
    check_surface(random, soup, repaired(soup), tried, 1e-8);
  }
  CHECK(tried.layered > enough(1000));
}

TEST_CASE("of a closed block the top is left as it was, and neither base nor walls") {
  for (std::uint64_t seed = 1; seed <= last_seed(30); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    const int columns = random.whole(2, 9), rows = random.whole(2, 9);
    const TriangleSoup soup = block(random, columns, rows);
    std::vector<std::string> notes;
    const Tin tin = repaired(soup, &notes);
    const auto top = static_cast<std::size_t>(2 * (columns - 1) * (rows - 1));
    const int rim = 2 * (columns + rows - 2);
    REQUIRE(tin.triangles ==
            std::vector(soup.triangles.begin(), soup.triangles.begin() + static_cast<long>(top)));
    REQUIRE(tin.vertices_m.size() == static_cast<std::size_t>(columns * rows));
    REQUIRE(std::equal(tin.vertices_m.begin(), tin.vertices_m.end(), soup.points_m.begin()));
    REQUIRE(notes.size() >= 2);
    CHECK(notes[notes.size() - 2] ==
          std::to_string(rim) + " triangles are hidden seen from above and were dropped.");
    CHECK(notes.back() == std::to_string(2 * rim) +
                              " vertical triangles fit nothing that is left and were dropped.");
  }
}

TEST_CASE("triangles given twice are left once, bit for bit") {
  for (std::uint64_t seed = 1; seed <= last_seed(50); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    MadeTin wanted;
    wanted.missing = 0.1;
    const Tin tin = made_tin(random, wanted);
    TriangleSoup soup = soup_of(tin);
    for (int i = random.whole(1, 5); i > 0; --i)
      soup.triangles.push_back(soup.triangles[static_cast<std::size_t>(
          random.whole(0, static_cast<int>(tin.triangles.size()) - 1))]);
    REQUIRE(repaired(soup) == tin);
  }
}

TEST_CASE("what overlaps nothing stays bit for bit, walls in it too") {
  int far = 0;
  for (std::uint64_t seed = 1; seed <= last_seed(100); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    MadeTin wanted;
    wanted.columns = wanted.rows = 10;
    wanted.walls = 0.6;
    const Tin tin = made_tin(random, wanted);
    TriangleSoup soup = soup_of(tin);
    // A roof over some of it.
    const double x = random.between(20, 60), y = random.between(20, 60);
    add(soup, {{{x, y, 200}, {x + 15, y + 2, 210}, {x + 4, y + 15, 190}}, {{0, 1, 2}}});
    const Tin left = repaired(soup);
    // Those whose boxes are two steps away or more can't have been touched.
    std::set<std::array<double, 9>> there;
    const auto corners = [](const Tin& t, std::size_t i) {
      const Vec3 a = t.vertices_m[t.triangles[i][0]], b = t.vertices_m[t.triangles[i][1]],
                 c = t.vertices_m[t.triangles[i][2]];
      return std::array{a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z};
    };
    for (std::size_t i = 0; i < left.triangles.size(); ++i) there.insert(corners(left, i));
    for (std::size_t i = 0; i < tin.triangles.size(); ++i) {
      bool away = true;
      for (const std::uint32_t v : tin.triangles[i]) {
        const Vec3& p = tin.vertices_m[v];
        away = away && (p.x < x - 30 || p.x > x + 45 || p.y < y - 30 || p.y > y + 45);
      }
      if (!away) continue;
      ++far;
      REQUIRE(there.contains(corners(tin, i)));
    }
    Tried tried;
    check_surface(random, soup, left, tried);
    for (const Vec3& p : left.vertices_m) { // nothing of what is below cuts the roof but at its rim
      const HighestAt roof = highest_at(soup.points_m, {soup.triangles.back()}, {p.x, p.y}, 1e-6);
      REQUIRE((!roof.height_m || roof.close_to_an_edge));
    }
  }
  CHECK(far > enough(1000));
}

TEST_CASE("no cracks open beside a triangle that was cut") {
  // Borders run round the whole and round the roof, below it and above it; nowhere else.
  const auto border_m = [](const Tin& tin) {
    double sum = 0;
    for (std::size_t t = 0; t < tin.triangles.size(); ++t)
      for (std::size_t k = 0; k < 3; ++k) {
        if (tin.neighbours[t][k] != kNoTriangle) continue;
        const Vec3 a = tin.vertices_m[tin.triangles[t][(k + 1) % 3]],
                   b = tin.vertices_m[tin.triangles[t][(k + 2) % 3]];
        sum += std::hypot(a.x - b.x, a.y - b.y);
      }
    return sum;
  };
  const double outline = 30 + 2 * std::hypot(10, 5);
  TriangleSoup soup{{{0, 0, 0},
                     {10, 0, 1},
                     {10, 10, 3},
                     {0, 10, 7},
                     {20, 5, 0},
                     {3, 4, 9},
                     {7, 3, 9},
                     {6, 5.5, 9}},
                    {{0, 1, 2}, {0, 2, 3}, {1, 4, 2}, {5, 6, 7}}};
  // Over two of the triangles.
  double roof = std::hypot(4, 1) + std::hypot(1, 2.5) + std::hypot(3, 1.5);
  CHECK(border_m(repaired(soup)) == Approx(outline + 2 * roof).epsilon(1e-12));
  // Over one of them, with a corner on the edge to the other, which is cut too.
  soup.points_m[5] = {5, 5, 9};
  soup.points_m[6] = {7, 2, 9};
  soup.points_m[7] = {8, 4, 9};
  roof = std::hypot(2, 3) + std::hypot(1, 2) + std::hypot(3, 1);
  CHECK(border_m(repaired(soup)) == Approx(outline + 2 * roof).epsilon(1e-12));
}

TEST_CASE("what is below leaves no points in what is above") {
  const TriangleSoup soup{
      {{0, 0, 9}, {10, 0, 9}, {10, 10, 9}, {0, 10, 9}, {-5, 4, 0}, {15, 4.5, 0}, {5, 20, 0}},
      {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}}};
  const Tin tin = repaired(soup);
  for (const Vec3& p : tin.vertices_m)
    CHECK_FALSE((p.x > 0.01 && p.x < 9.99 && p.y > 0.01 && p.y < 9.99));
}

TEST_CASE("a fin on an edge is dropped, and nothing else") {
  const TriangleSoup soup{{{0, 0, 0}, {10, 0, 1}, {10, 10, 3}, {0, 10, 7}, {0, 0, 5}},
                          {{0, 1, 2}, {0, 2, 4}, {0, 2, 3}}};
  const Tin tin = repaired(soup);
  CHECK(tin.triangles == std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}, {0, 2, 3}});
}

} // namespace orograph::upper_surface_test
