// SPDX-License-Identifier: GPL-3.0-or-later
// The triangulation of a grid's vertices against what makes one Delaunay, in whole numbers.
#include "dem/approximate/lattice_triangulation.hpp"
#include "tests/catch.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace orograph::lattice_triangulation_test {
namespace {

using Place = std::pair<int, int>;

bool is_in(LatticePoint a, LatticePoint b, LatticePoint c, LatticePoint p) {
  return twice_area(a, b, p) >= 0 && twice_area(b, c, p) >= 0 && twice_area(c, a, p) >= 0;
}

// By lifting to 1000000 (x^2 + y^2) - x y: whether p lies below the plane through a, b and c.
// Coordinates up to 20 or so.
bool circle_holds(LatticePoint a, LatticePoint b, LatticePoint c, LatticePoint p) {
  const auto height = [](LatticePoint v) {
    const std::int64_t x = v.column, y = v.row;
    return 1000000 * (x * x + y * y) - x * y;
  };
  return twice_area(b, c, p) * height(a) + twice_area(c, a, p) * height(b) +
             twice_area(a, b, p) * height(c) >
         twice_area(a, b, c) * height(p);
}

void check_triangulation(const LatticeTriangulation& made, int columns, int rows) {
  const auto& triangles = made.triangles();
  std::int64_t area = 0;
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    const LatticePoint a = made.corner(triangles[t], 0), b = made.corner(triangles[t], 1),
                       c = made.corner(triangles[t], 2);
    REQUIRE(twice_area(a, b, c) > 0);
    area += twice_area(a, b, c);
    for (const LatticePoint p : made.points()) REQUIRE_FALSE(circle_holds(a, b, c, p));
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t one = triangles[t].vertices[(k + 1) % 3],
                          other = triangles[t].vertices[(k + 2) % 3];
      std::uint32_t across = LatticeTriangulation::kNone;
      for (std::uint32_t u = 0; u < triangles.size(); ++u)
        for (std::size_t j = 0; j < 3; ++j)
          if (triangles[u].vertices[j] == other && triangles[u].vertices[(j + 1) % 3] == one)
            across = u;
      REQUIRE(triangles[t].neighbours[k] == across);
    }
  }
  REQUIRE(area == 2 * std::int64_t{columns - 1} * (rows - 1));
}

// The grid's edges between vertices that are in it are edges of it.
void check_grid_edges(const LatticeTriangulation& made) {
  std::set<std::pair<Place, Place>> edges;
  std::set<Place> points;
  const auto place = [](LatticePoint p) { return Place{p.column, p.row}; };
  for (const LatticePoint p : made.points()) points.insert(place(p));
  for (const auto& triangle : made.triangles())
    for (int k = 0; k < 3; ++k)
      for (const int other : {(k + 1) % 3, (k + 2) % 3})
        edges.insert({place(made.corner(triangle, k)), place(made.corner(triangle, other))});
  for (const Place& p : points)
    for (const Place& step : {Place{1, 0}, Place{0, 1}, Place{1, 1}})
      if (const Place to{p.first + step.first, p.second + step.second}; points.contains(to))
        REQUIRE(edges.contains({p, to}));
}

// In any order; all vertices of the rectangle but its corners.
std::vector<LatticePoint> shuffled_points(Random& random, int columns, int rows) {
  std::vector<LatticePoint> points;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column)
      if ((column > 0 && column < columns - 1) || (row > 0 && row < rows - 1))
        points.push_back({column, row});
  for (std::size_t i = points.size(); i > 1; --i)
    std::swap(points[i - 1],
              points[static_cast<std::size_t>(random.whole(0, static_cast<int>(i) - 1))]);
  return points;
}

} // namespace

TEST_CASE("any vertices of a grid make a Delaunay triangulation with the grid's own edges") {
  for (std::uint64_t seed = 1; seed <= last_seed(300); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    const int columns = random.whole(2, 8), rows = random.whole(2, 8);
    auto points = shuffled_points(random, columns, rows);
    if (random.chance(0.7) && !points.empty())
      points.resize(static_cast<std::size_t>(random.whole(0, static_cast<int>(points.size()))));

    LatticeTriangulation made(columns, rows);
    for (const LatticePoint point : points) {
      const std::uint32_t near = static_cast<std::uint32_t>(
          random.whole(0, static_cast<int>(made.triangles().size()) - 1));
      const std::uint32_t holder = made.find(point, near);
      const auto& at = made.triangles()[holder];
      REQUIRE(is_in(made.corner(at, 0), made.corner(at, 1), made.corner(at, 2), point));

      const auto before = made.triangles();
      const auto changed = made.add(point, holder);
      const auto vertex = static_cast<std::uint32_t>(made.points().size() - 1);
      for (std::uint32_t t = 0; t < made.triangles().size(); ++t) {
        const auto& now = made.triangles()[t].vertices;
        const bool is_around = std::find(now.begin(), now.end(), vertex) != now.end();
        REQUIRE(std::count(changed.begin(), changed.end(), t) == (is_around ? 1 : 0));
        if (!is_around) REQUIRE(before[t].vertices == now);
      }
    }
    check_triangulation(made, columns, rows);
    check_grid_edges(made);
  }
}

TEST_CASE("all vertices of a grid have the grid's own triangles") {
  Random random(5);
  LatticeTriangulation made(6, 7);
  for (const LatticePoint point : shuffled_points(random, 6, 7))
    made.add(point, made.find(point, 0));
  REQUIRE(made.triangles().size() == 2 * 5 * 6);
  check_grid_edges(made);
}

TEST_CASE("the largest rectangle is triangulated as a small one of the same shape") {
  Random random(6);
  constexpr int size = 1 << 10, scale = 1 << 20; // 2^30 - 2^20 + 1 columns
  LatticeTriangulation small(size, size), large((size - 1) * scale + 1, (size - 1) * scale + 1);
  std::set<Place> used{{0, 0}, {size - 1, 0}, {0, size - 1}, {size - 1, size - 1}};
  while (used.size() < 300) {
    // Many on few lines, so that many circles hold four.
    const int step = random.pick({1, 1, 93, 341});
    const LatticePoint p{random.whole(0, (size - 1) / step) * step,
                         random.whole(0, (size - 1) / step) * step};
    if (!used.insert({p.column, p.row}).second) continue;
    small.add(p, small.find(p, 0));
    const LatticePoint q{p.column * scale, p.row * scale};
    large.add(q, large.find(q, 0));
  }
  for (std::size_t t = 0; t < small.triangles().size(); ++t)
    REQUIRE(small.triangles()[t].vertices == large.triangles()[t].vertices);
}

TEST_CASE("the insertion order has every point once, and begins with few from everywhere") {
  std::vector<LatticePoint> points;
  for (int row = 0; row < 64; ++row)
    for (int column = 0; column < 64; ++column) points.push_back({column, row});
  const auto ordered = insertion_order(points);
  std::set<Place> seen;
  for (const LatticePoint p : ordered) seen.insert({p.column, p.row});
  CHECK(ordered.size() == points.size());
  CHECK(seen.size() == points.size());
  std::set<Place> quarters;
  for (std::size_t i = 0; i < 100; ++i)
    quarters.insert({ordered[i].column / 32, ordered[i].row / 32});
  CHECK(quarters.size() == 4);
}

} // namespace orograph::lattice_triangulation_test
