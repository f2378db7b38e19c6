// SPDX-License-Identifier: GPL-3.0-or-later
#include "profiles/outline.hpp"
#include "tests/catch.hpp"
#include "tests/support/made_grid.hpp"
#include "tests/support/random.hpp"

#include <algorithm>

namespace orograph::outline_test {
namespace {

// As directed edges with the terrain on the left, sorted.
std::vector<DirectedEdge> directed(const std::vector<BorderEdge>& border) {
  std::vector<DirectedEdge> edges;
  for (const auto& [edge, left] : border)
    edges.push_back(left ? DirectedEdge{edge.from, edge.to} : DirectedEdge{edge.to, edge.from});
  std::sort(edges.begin(), edges.end());
  return edges;
}

bool is_in_order(const std::vector<BorderEdge>& border) {
  return std::is_sorted(border.begin(), border.end(),
                        [](const BorderEdge& a, const BorderEdge& b) { return a.edge < b.edge; });
}

} // namespace

TEST_CASE("the border is the edges with one triangle, which is on their left") {
  for (std::uint64_t seed = 1; seed <= last_seed(1000); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    const GridLattice lattice =
        turned_lattice(random.whole(2, 9), random.whole(2, 9), {10, 12}, random.between(-0.7, 0.7));
    GridHeights heights;
    heights.missing = random.pick({0.0, 0.05, 0.3, 0.6, 1.0});
    heights.in_double = random.chance(0.5);
    const Grid grid = made_grid(random, lattice, heights);
    const std::vector<DirectedEdge> expected = outline_by_triangles(grid);

    const std::vector<BorderEdge> border = border_edges(grid, false);
    for (const BorderEdge& b : border) REQUIRE(b.edge.from < b.edge.to);
    REQUIRE(is_in_order(border));
    REQUIRE(directed(border) == expected);
    if (heights.missing == 0) {
      const std::vector<BorderEdge> hull = border_edges(grid, true);
      REQUIRE(is_in_order(hull));
      REQUIRE(directed(hull) == expected);
    }

    const std::vector<OutlineEdge> outline = outline_of(grid, border);
    REQUIRE(outline.size() == border.size());
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const auto& [edge, left] = border[i];
      REQUIRE(outline[i].from == vertex_m(grid, left ? edge.from : edge.to));
      REQUIRE(outline[i].to == vertex_m(grid, left ? edge.to : edge.from));
    }
  }
}

TEST_CASE("heights missing in long rows") {
  for (std::uint64_t seed = 1; seed <= last_seed(200); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    const GridLattice lattice =
        turned_lattice(random.whole(60, 330), random.whole(2, 8), {10, 12}, 0);
    GridHeights heights;
    heights.missing = random.pick({0.0, 0.0005, 0.002, 0.01, 0.5, 0.999, 1.0});
    heights.in_double = random.chance(0.5);
    const Grid grid = made_grid(random, lattice, heights);
    REQUIRE(directed(border_edges(grid, false)) == outline_by_triangles(grid));
  }
}

} // namespace orograph::outline_test
