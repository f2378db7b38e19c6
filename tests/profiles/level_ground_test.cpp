// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/approximate/tin_of_grid.hpp"
#include "dem/tin.hpp"
#include "profiles/level_ground.hpp"
#include "tests/catch.hpp"
#include "tests/support/made_grid.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <cstdint>
#include <set>
#include <vector>

namespace orograph::level_ground_test {
namespace {

struct Flooded {
  std::vector<bool> level; ///< by triangle, as triangles_of numbers them
  std::size_t regions = 0;
};

bool is_level(const Grid& grid, const GridTriangle& triangle) {
  const auto height = [&](std::size_t k) { return vertex_m(grid, triangle.vertices[k]).z; };
  return height(0) == height(1) && height(0) == height(2);
}

// Every level triangle floods its neighbours, one after another.
Flooded flood(const Grid& grid, const std::vector<GridTriangle>& triangles, std::size_t smallest) {
  const auto edges = directed_edges(triangles);
  Flooded found{std::vector<bool>(triangles.size(), false), 0};
  std::vector<bool> seen(triangles.size(), false);
  for (std::size_t first = 0; first < triangles.size(); ++first) {
    if (seen[first] || !is_level(grid, triangles[first])) continue;
    std::vector<std::size_t> region{first};
    seen[first] = true;
    for (std::size_t i = 0; i < region.size(); ++i)
      for (std::size_t k = 0; k < 3; ++k) {
        const auto& at = triangles[region[i]].vertices;
        const auto other = edges.find({at[(k + 1) % 3], at[k]});
        if (other == edges.end() || seen[other->second]) continue;
        if (!is_level(grid, triangles[other->second])) continue;
        seen[other->second] = true;
        region.push_back(other->second);
      }
    if (region.size() < smallest) continue;
    ++found.regions;
    for (const std::size_t i : region) found.level[i] = true;
  }
  return found;
}

std::vector<DirectedEdge> shores_by_triangles(const std::vector<GridTriangle>& triangles,
                                              const std::vector<bool>& level) {
  const auto edges = directed_edges(triangles);
  std::vector<DirectedEdge> shores;
  for (const auto& [edge, left] : edges) {
    const auto right = edges.find({edge.second, edge.first});
    if (right != edges.end() && level[left] && !level[right->second])
      shores.push_back(std::minmax(edge.first, edge.second));
  }
  std::sort(shores.begin(), shores.end());
  return shores;
}

// How many regions there are.
std::size_t check_against_flood(const Grid& grid, std::size_t smallest) {
  const auto triangles = triangles_of(grid);
  const Flooded expected = flood(grid, triangles, smallest);

  const LevelGround found = find_level_ground(grid, smallest);
  REQUIRE(found.regions == expected.regions);
  REQUIRE(found.triangles.empty() == (expected.regions == 0));
  if (expected.regions > 0) {
    std::size_t there = 0, marked = 0;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      const auto& [vertices, column, row, half] = triangles[i];
      REQUIRE(found.triangles.has(grid_triangle(grid, column, row, half)) == expected.level[i]);
      there += expected.level[i];
    }
    for (int row = 0; row + 1 < grid.rows; ++row)
      for (int column = 0; column + 1 < grid.columns; ++column)
        for (const Half half : {Half::lower, Half::upper})
          marked += found.triangles.has(grid_triangle(grid, column, row, half));
    REQUIRE(marked == there);
  }
  std::vector<DirectedEdge> shores;
  for (const SurfaceEdge& edge : found.shores) shores.emplace_back(edge.from, edge.to);
  std::sort(shores.begin(), shores.end());
  REQUIRE(shores == shores_by_triangles(triangles, expected.level));
  return found.regions;
}

} // namespace

TEST_CASE("level ground and its shores are what a flood fill finds") {
  std::size_t regions = 0;
  for (std::uint64_t seed = 1; seed <= last_seed(1500); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    GridHeights heights;
    heights.high = random.pick({1.2, 1.5, 2.0, 3.0}); // 0 and now and then 1 or 2
    heights.whole = true;
    heights.missing = random.pick({0.0, 0.02, 0.2});
    heights.in_double = random.chance(0.5);
    const Grid grid = made_grid(random, {random.whole(2, 12), random.whole(2, 12)}, heights);
    const auto smallest = static_cast<std::size_t>(random.pick({1, 2, 3, 8, 30}));
    regions += check_against_flood(grid, smallest);
  }
  REQUIRE(regions > enough(1500)); // the scenes do have level ground
}

TEST_CASE("level ground on wide slopes, looked at in several parts, is what a flood fill finds") {
  std::size_t regions = 0;
  for (std::uint64_t seed = 1; seed <= last_seed(8); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    const int columns = random.whole(180, 260), rows = random.whole(150, 200);
    Grid grid{columns, rows, PlaneLattice{{}, {1, 0}, {0, -1}}, std::vector<float>()};
    std::vector<float> heights(grid.size());
    for (int row = 0; row < rows; ++row)
      for (int column = 0; column < columns; ++column)
        heights[grid.index(column, row)] = static_cast<float>(1 + row + 3 * column);
    for (int lake = 0; lake < 40; ++lake) { // some over others, some up to the border
      const int west = random.whole(0, columns - 2), north = random.whole(0, rows - 2);
      const int east = std::min(columns - 1, west + random.whole(1, 90));
      const int south = std::min(rows - 1, north + random.whole(1, 60));
      const float height = static_cast<float>(-random.whole(1, 3));
      for (int row = north; row <= south; ++row)
        for (int column = west; column <= east; ++column)
          if (!random.chance(0.001)) heights[grid.index(column, row)] = height;
    }
    grid.heights_m = heights;
    regions += check_against_flood(grid, static_cast<std::size_t>(random.pick({1, 30})));
  }
  REQUIRE(regions > enough(40));
}

TEST_CASE("water has at least 500 triangles and a five-thousandth of the grid") {
  const auto regions = [](int side, int level_cells) {
    Grid grid{side, side, PlaneLattice{{}, {1, 0}, {0, -1}}, std::vector<float>()};
    std::vector<float> heights(grid.size());
    for (int row = 0; row < side; ++row)
      for (int column = 0; column < side; ++column)
        heights[grid.index(column, row)] =
            row <= 1 && column <= level_cells ? 0.F : static_cast<float>(1 + row + 3 * column);
    grid.heights_m = heights;
    return find_water(grid).regions;
  };
  CHECK(regions(300, 249) == 0);
  CHECK(regions(300, 250) == 1); // 500 triangles
  CHECK(regions(1500, 449) == 0);
  CHECK(regions(1500, 450) == 1); // 900 of 4,500,000
}

TEST_CASE("the border of a set of triangles is that of those who have it alone") {
  std::size_t edges = 0, of_set = 0;
  for (std::uint64_t seed = 1; seed <= last_seed(500); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    GridHeights heights;
    heights.missing = random.pick({0.0, 0.05, 0.3});
    const Grid grid = made_grid(random, {random.whole(2, 9), random.whole(2, 9)}, heights);
    const std::vector<GridTriangle> triangles = triangles_of(grid);
    if (triangles.empty()) continue;
    const Tin tin = tin_of(grid);
    TriangleSet of_grid(grid_triangle_count(grid)), of_tin(tin.triangles.size());
    std::set<std::set<std::uint32_t>> chosen, chosen_of_tin;
    for (const auto& [vertices, column, row, half] : triangles) {
      if (random.chance(0.5)) continue;
      of_grid.add(grid_triangle(grid, column, row, half));
      chosen.insert({vertices.begin(), vertices.end()});
    }
    for (std::size_t t = 0; t < tin.triangles.size(); ++t) {
      if (random.chance(0.5)) continue;
      of_tin.add(t);
      chosen_of_tin.insert({tin.triangles[t].begin(), tin.triangles[t].end()});
    }
    const auto check = [&](const Surface& surface, const std::vector<BorderEdge>& border,
                           const TriangleSet& set,
                           const std::set<std::set<std::uint32_t>>& expected) {
      const std::vector<bool> found = borders_of(surface, border, set);
      REQUIRE(found.size() == border.size());
      bool same = true;
      for (std::size_t i = 0; i < border.size(); ++i) {
        const auto& [from, to] = border[i].edge;
        const bool is_of_set =
            std::any_of(expected.begin(), expected.end(), [&](const auto& vertices) {
              return vertices.contains(from) && vertices.contains(to);
            });
        same &= found[i] == is_of_set;
        of_set += is_of_set ? 1U : 0U;
      }
      edges += border.size();
      CHECK(same);
    };
    check(grid, border_edges(grid, false), of_grid, chosen);
    check(tin, border_edges(tin), of_tin, chosen_of_tin);
  }
  CHECK(of_set > edges / 4);
  CHECK(of_set < edges);
}

} // namespace orograph::level_ground_test
