// SPDX-License-Identifier: GPL-3.0-or-later
// An approximated grid against every triangle of the Tin at every vertex of the grid, every pair of
// edges, and the ground that each two triangles share. All in columns and rows.
#include "data_samples/terrains.hpp"
#include "dem/approximate/approximate_grid.hpp"
#include "dem/mesh/verify_tin.hpp"
#include "geometry/error.hpp"
#include "tests/catch.hpp"
#include "tests/dem/approximate/grid_triangles.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace orograph::approximate_grid_test {
namespace {

// The same triangles with column and row as x and y.
std::vector<Corners> in_columns_and_rows(const Grid& grid) {
  std::vector<Corners> all;
  for (const GridTriangle& triangle : triangles_of(grid)) {
    Corners corners;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto v = static_cast<int>(triangle.vertices[k]);
      const double column = v % grid.columns, row = v / grid.columns;
      corners[k] = {column, row, vertex_m(grid, triangle.vertices[k]).z};
    }
    all.push_back(corners);
  }
  return all;
}

// Fails where a vertex isn't one of the grid's, in position and height, to the last bit.
std::vector<Corners> in_columns_and_rows(const Tin& tin, const Grid& grid) {
  std::map<std::pair<double, double>, std::uint32_t> index_of;
  for (std::uint32_t i = 0; i < grid.size(); ++i) {
    const Vec3 v = vertex_m(grid, i);
    index_of[{v.x, v.y}] = i;
  }
  std::vector<Vec3> vertices;
  for (const Vec3& v : tin.vertices_m) {
    const auto found = index_of.find({v.x, v.y});
    REQUIRE(found != index_of.end());
    REQUIRE(vertex_m(grid, found->second) == v);
    const auto index = static_cast<int>(found->second);
    const double column = index % grid.columns, row = index / grid.columns;
    vertices.push_back({column, row, v.z});
  }
  std::vector<Corners> all;
  for (const auto& [a, b, c] : tin.triangles)
    all.push_back({vertices[a], vertices[b], vertices[c]});
  return all;
}

double height_on(const Corners& t, Vec2 p) {
  const double area = twice_area_m2(t);
  const double b = cross(p - ground(t[0]), ground(t[2]) - ground(t[0])) / area;
  const double c = cross(ground(t[1]) - ground(t[0]), p - ground(t[0])) / area;
  return t[0].z * (1 - b - c) + t[1].z * b + t[2].z * c;
}

// Exact for whole numbers.
bool holds(const Corners& t, Vec2 p) {
  const double side = twice_area_m2(t) > 0 ? 1 : -1;
  for (std::size_t k = 0; k < 3; ++k)
    if (side * cross(ground(t[(k + 1) % 3]) - ground(t[k]), p - ground(t[k])) < 0) return false;
  return true;
}

double greatest_at_vertices(const std::vector<Corners>& grid, const std::vector<Corners>& tin) {
  double greatest = 0;
  for (const Corners& of_grid : grid)
    for (const Vec3& vertex : of_grid)
      for (const Corners& of_tin : tin)
        if (holds(of_tin, ground(vertex)))
          greatest = std::max(greatest, std::abs(height_on(of_tin, ground(vertex)) - vertex.z));
  return greatest;
}

double greatest_at_crossings(const std::vector<Corners>& grid, const std::vector<Corners>& tin) {
  double greatest = 0;
  for (const Corners& one : grid)
    for (const Corners& other : tin)
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t k = 0; k < 3; ++k) {
          const Vec3 a = one[i], b = one[(i + 1) % 3], c = other[k], d = other[(k + 1) % 3];
          const Vec2 ab = ground(b) - ground(a), cd = ground(d) - ground(c);
          const double turn = cross(ab, cd);
          if (turn == 0) continue;
          const double s = cross(ground(c) - ground(a), cd) / turn;
          const double t = cross(ground(c) - ground(a), ab) / turn;
          if (s < 0 || s > 1 || t < 0 || t > 1) continue;
          greatest = std::max(greatest, std::abs(a.z + s * (b.z - a.z) - (c.z + t * (d.z - c.z))));
        }
  return greatest;
}

double area_of(const std::vector<Vec2>& polygon) {
  double twice = 0;
  for (std::size_t i = 2; i < polygon.size(); ++i)
    twice += cross(polygon[i - 1] - polygon[0], polygon[i] - polygon[0]);
  return std::abs(twice) / 2;
}

// Of the ground that two triangles share: one is cut by the other's three sides.
double shared_area(const Corners& one, const Corners& other) {
  std::vector<Vec2> kept{ground(one[0]), ground(one[1]), ground(one[2])};
  const double side = twice_area_m2(other) > 0 ? 1 : -1;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec2 from = ground(other[k]), along = ground(other[(k + 1) % 3]) - from;
    std::vector<Vec2> next;
    for (std::size_t i = 0; i < kept.size(); ++i) {
      const Vec2 p = kept[i], q = kept[(i + 1) % kept.size()];
      const double at_p = side * cross(along, p - from), at_q = side * cross(along, q - from);
      if (at_p >= 0) next.push_back(p);
      if ((at_p > 0 && at_q < 0) || (at_p < 0 && at_q > 0))
        next.push_back(p + at_p / (at_p - at_q) * (q - p));
    }
    kept = std::move(next);
  }
  return area_of(kept);
}

bool boxes_meet(const Corners& one, const Corners& other) {
  const auto range = [](const Corners& t, double Vec3::*axis) {
    return std::minmax({t[0].*axis, t[1].*axis, t[2].*axis});
  };
  for (double Vec3::*axis : {&Vec3::x, &Vec3::y}) {
    const auto a = range(one, axis), b = range(other, axis);
    if (a.second <= b.first || b.second <= a.first) return false;
  }
  return true;
}

// Each of the grid's triangles is covered once, and nothing else is.
void check_same_ground(const std::vector<Corners>& grid, const std::vector<Corners>& tin) {
  double area = 0;
  for (const Corners& triangle : tin) area += std::abs(twice_area_m2(triangle)) / 2;
  REQUIRE(area == static_cast<double>(grid.size()) / 2);
  for (const Corners& of_grid : grid) {
    double covered = 0;
    for (const Corners& of_tin : tin)
      if (boxes_meet(of_grid, of_tin)) covered += shared_area(of_grid, of_tin);
    REQUIRE(covered == Approx(0.5).epsilon(1e-12));
  }
}

// Of the grid's outline, all vertices that don't lie on the grid's own end.
void check_outline_is_kept(const Grid& grid, const Tin& tin) {
  std::set<std::pair<double, double>> kept;
  for (const Vec3& v : tin.vertices_m) kept.insert({v.x, v.y});
  for (const auto& [from, to] : outline_by_triangles(grid)) {
    const auto column = static_cast<int>(from) % grid.columns;
    const auto row = static_cast<int>(from) / grid.columns;
    if (column == 0 || row == 0 || column == grid.columns - 1 || row == grid.rows - 1) continue;
    const Vec3 v = vertex_m(grid, from);
    REQUIRE(kept.contains({v.x, v.y}));
  }
}

} // namespace

TEST_CASE("an approximated grid covers the grid's ground, within the bound everywhere") {
  std::size_t triangles = 0, triangles_of_grids = 0;
  for (std::uint64_t seed = 1; seed <= last_seed(1200); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    const Grid grid = any_small_grid(random, 10);
    const auto of_grid = in_columns_and_rows(grid);
    if (of_grid.empty()) continue;
    const double bound = random.pick({1e-300, 0.1, 1.0, 5.0, 20.0, 60.0, 1e300});
    CAPTURE(bound);
    const ApproximatedGrid made = approximate(grid, bound);
    const auto of_tin = in_columns_and_rows(made.tin, grid);
    for (const Corners& triangle : corners_of(made.tin)) REQUIRE(twice_area_m2(triangle) > 0);
    REQUIRE(made.tin.neighbours == neighbours_by_pairs(made.tin));
    REQUIRE_FALSE(verify(made.tin));
    check_same_ground(of_grid, of_tin);
    check_outline_is_kept(grid, made.tin);

    const double at_vertices = greatest_at_vertices(of_grid, of_tin);
    const double anywhere = std::max(at_vertices, greatest_at_crossings(of_grid, of_tin));
    REQUIRE(std::abs(made.greatest_at_vertices_m - at_vertices) <= 1e-10);
    REQUIRE(std::abs(made.greatest_m - anywhere) <= 1e-10);
    REQUIRE(made.greatest_at_vertices_m <= made.greatest_m);
    REQUIRE(made.greatest_m <= bound);

    // Places at random: no farther than where edges cross.
    for (int i = 0; i < 30; ++i) {
      const Vec2 p{random.between(0, grid.columns - 1), random.between(0, grid.rows - 1)};
      for (const Corners& one : of_grid)
        for (const Corners& other : of_tin)
          if (holds(one, p) && holds(other, p))
            REQUIRE(std::abs(height_on(one, p) - height_on(other, p)) <= anywhere + 1e-10);
    }
    triangles += of_tin.size();
    triangles_of_grids += of_grid.size();
  }
  CHECK(triangles < 0.9 * static_cast<double>(triangles_of_grids)); // it does leave some out
}

TEST_CASE("a plane needs two triangles, however the grid lies") {
  for (const double turn : {0.0, 0.3, 2.0}) {
    const GridLattice lattice = turned_lattice(30, 20, {10, 10}, turn);
    Grid grid{30, 20, PlaneLattice{{}, lattice.column_step_m, lattice.row_step_m},
              std::vector<double>()};
    std::vector<double> heights;
    for (int row = 0; row < 20; ++row)
      for (int column = 0; column < 30; ++column) heights.push_back(100 + 3 * column - 0.5 * row);
    grid.heights_m = std::move(heights);
    const ApproximatedGrid made = approximate(grid, 1e-9);
    CHECK(made.tin.triangles.size() == 2);
    CHECK(made.tin.vertices_m.size() == 4);
    CHECK(made.greatest_m <= 1e-12);
  }
}

TEST_CASE("a bound of 0 gives the grid's own triangles") {
  for (std::uint64_t seed = 1; seed <= last_seed(20); ++seed) {
    Random random(seed);
    const Grid grid = any_small_grid(random, 9);
    if (triangles_of(grid).empty()) continue;
    const ApproximatedGrid made = approximate(grid, 0);
    CHECK(made.tin == tin_of(grid));
    CHECK(made.greatest_at_vertices_m == 0);
    CHECK(made.greatest_m == 0);
  }
}

TEST_CASE("a grid without a triangle can't be approximated") {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  for (const double bound : {0.0, 1.0}) {
    CHECK_THROWS_AS(approximate(Grid{}, bound), Error);
    CHECK_THROWS_AS(approximate({2, 2, PlaneLattice{{}, {1, 0}, {0, -1}},
                                 std::vector<double>{none, 1, 1, none}},
                                bound),
                    Error);
    CHECK_THROWS_AS(
        approximate({3, 1, PlaneLattice{{}, {1, 0}, {0, -1}}, std::vector<double>{1, 2, 3}}, bound),
        Error);
  }
}

TEST_CASE("the bound holds everywhere on rough ground too") {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    Random random(seed);
    GridHeights heights;
    heights.missing = random.pick({0.0, 0.001});
    heights.whole = random.chance(0.5);
    const Grid grid = made_grid(random, turned_lattice(70, 50, {10, 10}, 0), heights);
    for (const double bound : {10.0, 30.0, 40.0, 50.0, 60.0}) {
      CAPTURE(seed, bound);
      const ApproximatedGrid made = approximate(grid, bound);
      CHECK(made.greatest_m <= bound);
      CHECK_FALSE(verify(made.tin));
    }
  }
}

TEST_CASE("mountains are approximated with few triangles, islands with a level sea",
          "[unsanitized]") {
  for (const MadeTerrain terrain : {MadeTerrain::fractal_alps, MadeTerrain::islands}) {
    const Grid grid = make_terrain(terrain, 60);
    const auto of_grid = in_columns_and_rows(grid);
    std::size_t before = of_grid.size();
    for (const double bound : {20.0, 80.0, 300.0}) {
      CAPTURE(name_of(terrain), bound);
      const ApproximatedGrid made = approximate(grid, bound);
      CHECK(made.tin.triangles.size() < before);
      before = made.tin.triangles.size();
      CHECK(made.greatest_m <= bound);
      CHECK(made.greatest_m > bound / 2);
      if (bound < 300) continue;
      const auto of_tin = in_columns_and_rows(made.tin, grid);
      CHECK(greatest_at_vertices(of_grid, of_tin) == Approx(made.greatest_at_vertices_m));
      CHECK(of_tin.size() < of_grid.size() / 3);
    }
  }
}

} // namespace orograph::approximate_grid_test
