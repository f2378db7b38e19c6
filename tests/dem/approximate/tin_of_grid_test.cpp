// SPDX-License-Identifier: GPL-3.0-or-later
// The Tin of a grid against the plain list of the grid's triangles.
#include "dem/approximate/tin_of_grid.hpp"
#include "dem/mesh/verify_tin.hpp"
#include "tests/catch.hpp"
#include "tests/dem/approximate/grid_triangles.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <limits>
#include <set>

namespace orograph::tin_of_grid_test {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

Grid small_grid(int columns, int rows, std::vector<double> heights) {
  return {columns, rows, PlaneLattice{{}, {1, 0}, {0, -1}}, std::move(heights)};
}

} // namespace

TEST_CASE("the Tin of a grid has its triangles, in their order, and its vertices in theirs") {
  for (std::uint64_t seed = 1; seed <= last_seed(400); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    const Grid grid = any_small_grid(random, 9);
    const Tin tin = tin_of(grid);

    const auto expected = triangles_of(grid);
    std::set<std::uint32_t> used;
    for (const GridTriangle& triangle : expected)
      used.insert(triangle.vertices.begin(), triangle.vertices.end());
    std::vector<Vec3> vertices;
    std::vector<std::uint32_t> index_in_grid;
    for (const std::uint32_t vertex : used) {
      vertices.push_back(vertex_m(grid, vertex));
      index_in_grid.push_back(vertex);
    }
    REQUIRE(tin.vertices_m == vertices);

    REQUIRE(tin.triangles.size() == expected.size());
    const bool southward = cross(grid.plane().column_step_m, grid.plane().row_step_m) < 0;
    for (std::size_t t = 0; t < expected.size(); ++t) {
      auto triangle = tin.triangles[t];
      for (std::uint32_t& vertex : triangle) vertex = index_in_grid[vertex];
      if (!southward) std::swap(triangle[1], triangle[2]);
      CAPTURE(t);
      REQUIRE(triangle == expected[t].vertices);
      REQUIRE(twice_area_m2(corners_of(tin)[t]) > 0);
    }
    REQUIRE(tin.neighbours == neighbours_by_pairs(tin));
    if (!expected.empty()) REQUIRE_FALSE(verify(tin));
  }
}

TEST_CASE("grids without a triangle give an empty Tin") {
  for (const Grid& grid :
       {Grid{}, small_grid(1, 3, {1, 2, 3}), small_grid(3, 1, {1, 2, 3}),
        small_grid(2, 2, {kNone, 1, 1, kNone}), small_grid(2, 2, {kNone, kNone, kNone, kNone})}) {
    const Tin tin = tin_of(grid);
    CHECK(tin.vertices_m.empty());
    CHECK(tin.triangles.empty());
    CHECK(tin.neighbours.empty());
  }
}

TEST_CASE("single triangles, and parts that touch at a vertex only") {
  const Tin upper = tin_of(small_grid(2, 2, {1, 2, kNone, 4}));
  CHECK(upper.vertices_m == std::vector<Vec3>{{0, 0, 1}, {1, 0, 2}, {1, -1, 4}});
  CHECK(upper.triangles == std::vector<std::array<std::uint32_t, 3>>{{0, 2, 1}});
  const Tin lower = tin_of(small_grid(2, 2, {1, kNone, 3, 4}));
  CHECK(lower.triangles == std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}});

  // Two cells at opposite corners of the vertex in the middle.
  const Tin pinched = tin_of(small_grid(3, 3, {kNone, 2, 3, 4, 5, 6, 7, 8, kNone}));
  CHECK(pinched.vertices_m.size() == 7);
  CHECK(pinched.triangles.size() == 4);
  CHECK(pinched.neighbours == neighbours_by_pairs(pinched));
}

} // namespace orograph::tin_of_grid_test
