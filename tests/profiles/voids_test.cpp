// SPDX-License-Identifier: GPL-3.0-or-later
// Which edges lie around voids, against a flood over the missing triangles; and TINs by hand.
#include "dem/approximate/tin_of_grid.hpp"
#include "profiles/outline.hpp"
#include "tests/catch.hpp"
#include "tests/support/made_grid.hpp"
#include "tests/support/made_tin.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <set>
#include <vector>

namespace orograph::voids_test {
namespace {

using Vertex = std::pair<int, int>; // column, row
using Triangle = std::set<Vertex>;

// All triangles over the grid and one ring of cells around it, whether they are there or not.
std::vector<Triangle> all_triangles(const Grid& grid) {
  std::vector<Triangle> triangles;
  for (int r = -1; r < grid.rows; ++r)
    for (int c = -1; c < grid.columns; ++c) {
      triangles.push_back({{c, r}, {c, r + 1}, {c + 1, r + 1}});
      triangles.push_back({{c, r}, {c + 1, r}, {c + 1, r + 1}});
    }
  return triangles;
}

std::size_t shared_vertices(const Triangle& a, const Triangle& b) {
  return static_cast<std::size_t>(
      std::count_if(a.begin(), a.end(), [&](Vertex v) { return b.contains(v); }));
}

std::map<Vertex, std::vector<std::size_t>> by_vertex(const std::vector<Triangle>& triangles) {
  std::map<Vertex, std::vector<std::size_t>> at;
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (const Vertex& v : triangles[t]) at[v].push_back(t);
  return at;
}

// Those that are reached from triangle `first` over triangles that `may` be gone over, from one to
// the next where they share so many vertices: two are an edge.
std::vector<bool> flood(const std::vector<Triangle>& triangles,
                        const std::map<Vertex, std::vector<std::size_t>>& at, std::size_t first,
                        std::size_t shared, const std::function<bool(std::size_t)>& may) {
  std::vector<bool> reached(triangles.size());
  std::vector<std::size_t> queue{first};
  reached[first] = true;
  while (!queue.empty()) {
    const std::size_t t = queue.back();
    queue.pop_back();
    for (const Vertex& v : triangles[t])
      for (const std::size_t other : at.at(v))
        if (!reached[other] && may(other) &&
            shared_vertices(triangles[t], triangles[other]) >= shared) {
          reached[other] = true;
          queue.push_back(other);
        }
  }
  return reached;
}

struct Counts {
  std::size_t outer = 0, voids = 0, islands = 0;
};

// An edge is a void's if the missing triangle beside it isn't reached from outside over missing
// triangles; unless its terrain is cut off by that void from all that is outside: an island.
std::vector<bool> by_floods(const Grid& grid, const std::vector<BorderEdge>& border,
                            Counts& counts) {
  const std::vector<Triangle> triangles = all_triangles(grid);
  const auto at = by_vertex(triangles);
  std::vector<bool> missing;
  for (const Triangle& triangle : triangles)
    missing.push_back(std::any_of(triangle.begin(), triangle.end(), [&](Vertex v) {
      return v.first < 0 || v.second < 0 || v.first >= grid.columns || v.second >= grid.rows ||
             std::isnan(grid.height_m(v.first, v.second));
    }));
  const auto is_missing = [&](std::size_t t) { return missing[t]; };
  const std::vector<bool> outside = flood(triangles, at, 0, 2, is_missing);
  std::vector<bool> voids;
  for (const BorderEdge& b : border) {
    const auto vertex = [&](std::uint32_t i) {
      return Vertex{static_cast<int>(i) % grid.columns, static_cast<int>(i) / grid.columns};
    };
    std::size_t gap = 0, ground = 0;
    for (const std::size_t t : at.at(vertex(b.edge.from)))
      if (triangles[t].contains(vertex(b.edge.to))) (missing[t] ? gap : ground) = t;
    bool is_void = !outside[gap];
    if (is_void) {
      const std::vector<bool> of_void = flood(triangles, at, gap, 2, is_missing);
      is_void = flood(triangles, at, 0, 1, [&](std::size_t t) { return !of_void[t]; })[ground];
      ++(is_void ? counts.voids : counts.islands);
    } else {
      ++counts.outer;
    }
    voids.push_back(is_void);
  }
  return voids;
}

std::size_t count_of(const std::vector<bool>& voids) {
  return static_cast<std::size_t>(std::count(voids.begin(), voids.end(), true));
}

// Of triangles over vertices by number.
Tin tin_with(std::vector<Vec3> vertices, std::vector<std::array<std::uint32_t, 3>> triangles) {
  Tin tin;
  tin.vertices_m = std::move(vertices);
  tin.neighbours = neighbours_by_sorting(triangles);
  tin.triangles = std::move(triangles);
  return tin;
}

std::vector<bool> voids_of(const Tin& tin) {
  return around_voids(tin, border_edges(tin));
}

} // namespace

TEST_CASE("edges around voids are those that floods over missing triangles find") {
  const std::uint64_t kGrids = last_seed(3000);
  Counts counts;
  for (std::uint64_t seed = 1; seed <= kGrids; ++seed) {
    Random random(seed);
    CAPTURE(seed);
    GridLattice lattice = turned_lattice(random.whole(2, 13), random.whole(2, 13), {10, 12},
                                         random.between(-0.7, 0.7), random.between(-0.5, 0.5));
    if (random.chance(0.2)) lattice.row_step_m = -1.0 * lattice.row_step_m; // a mirror image
    GridHeights heights;
    heights.missing = random.pick({0.0, 0.03, 0.06, 0.1, 0.2, 0.4});
    Grid grid = made_grid(random, lattice, heights);
    if (random.chance(0.3) && grid.columns > 8 && grid.rows > 8) { // a moat, an island within
      const auto z = std::get<Heights<float>>(grid.heights_m).own();
      std::fill(z.begin(), z.end(), 1.0F);
      for (int r = 2; r < 7; ++r)
        for (int c = 2; c < 7; ++c)
          if (r == 2 || r == 6 || c == 2 || c == 6) z[grid.index(c, r)] = NAN;
      z[grid.index(random.whole(0, 8), random.whole(0, 8))] = random.pick({NAN, 1.0F});
    }
    const std::vector<BorderEdge> border = border_edges(grid, false);
    const std::vector<bool> expected = by_floods(grid, border, counts);
    REQUIRE(around_voids(grid, border) == expected);
    if (heights.missing == 0 && count_of(expected) == 0)
      REQUIRE(count_of(around_voids(grid, border_edges(grid, true))) == 0);

    // The TIN of its triangles, whose border comes in the same order; its vertices moved, too.
    Tin tin = tin_of(grid);
    REQUIRE(voids_of(tin) == expected);
    for (Vec3& v : tin.vertices_m)
      v = v + Vec3{random.between(-1, 1), random.between(-1, 1), random.between(-50, 50)};
    if (lattice.row_step_m.y < 0) REQUIRE(voids_of(tin) == expected);
  }
  WARN(counts.outer << " edges of outer borders, " << counts.voids << " of voids, "
                    << counts.islands << " of islands in voids");
  CHECK(counts.outer > 20 * kGrids);
  CHECK(counts.voids > 2 * kGrids);
  CHECK(counts.islands > kGrids / 5);
}

TEST_CASE("two voids that share a vertex are two, and a bay that touches the sea is a void") {
  // Five by five cells, two triangles each; the gaps are whole cells.
  const auto lattice = [](const std::set<Vertex>& gaps) {
    Tin tin;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    for (std::uint32_t r = 0; r < 6; ++r)
      for (std::uint32_t c = 0; c < 6; ++c) tin.vertices_m.push_back({1.0 * c, 1.0 * r, 0});
    for (std::uint32_t r = 0; r < 5; ++r)
      for (std::uint32_t c = 0; c < 5; ++c) {
        const std::uint32_t a = 6 * r + c;
        if (gaps.contains({static_cast<int>(c), static_cast<int>(r)})) continue;
        triangles.push_back({a, a + 1, a + 7});
        triangles.push_back({a, a + 7, a + 6});
      }
    return tin_with(tin.vertices_m, triangles);
  };
  CHECK(count_of(voids_of(lattice({}))) == 0);
  CHECK(count_of(voids_of(lattice({{2, 1}}))) == 4);
  CHECK(count_of(voids_of(lattice({{2, 1}, {3, 1}}))) == 6);
  CHECK(count_of(voids_of(lattice({{2, 1}, {2, 0}}))) == 0); // open to the south
  CHECK(count_of(voids_of(lattice({{2, 1}, {3, 0}}))) == 4); // by a vertex only
  CHECK(count_of(voids_of(lattice({{1, 1}, {2, 2}}))) == 8);
  // Four voids corner to corner: the ground between them is held at its corners, and no island.
  CHECK(count_of(voids_of(lattice({{2, 1}, {1, 2}, {3, 2}, {2, 3}}))) == 16);
  // A ring is one void; the ground in it is an island, with a border of its own.
  CHECK(count_of(voids_of(
            lattice({{1, 1}, {2, 1}, {3, 1}, {1, 2}, {3, 2}, {1, 3}, {2, 3}, {3, 3}}))) == 12);
  // A ring with a gap in it that is open to the south: all is outside.
  CHECK(count_of(voids_of(lattice(
            {{1, 1}, {2, 1}, {3, 1}, {1, 2}, {3, 2}, {1, 3}, {2, 3}, {3, 3}, {2, 0}}))) == 0);
}

TEST_CASE("around walls") {
  // A square of ground with a square void in its middle that walls lead down into: the border is at
  // their feet.
  std::vector<Vec3> vertices;
  for (const double half : {30.0, 10.0})
    for (const auto& [x, y] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
      vertices.push_back({1e5 + half * x, half * y, 100});
  for (std::size_t i = 4; i < 8; ++i) vertices.push_back({vertices[i].x, vertices[i].y, 50});
  std::vector<std::array<std::uint32_t, 3>> triangles;
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    triangles.push_back({a, b, c});
    triangles.push_back({a, c, d});
  };
  for (std::uint32_t i = 0; i < 4; ++i) {
    const std::uint32_t j = (i + 1) % 4;
    add(i, j, 4 + j, 4 + i);
    add(4 + i, 4 + j, 8 + j, 8 + i);
  }
  const auto voids_in = [&] { return count_of(voids_of(tin_with(vertices, triangles))); };
  CHECK(voids_in() == 4);
  // With one wall missing, its top and its sides are the void's border instead of its foot.
  triangles.resize(triangles.size() - 2);
  CHECK(voids_in() == 6);
  triangles.push_back({7, 4, 8});
  triangles.push_back({7, 8, 11});
  CHECK(voids_in() == 4);
  // A floor closes the void; with a window in one wall, which has no extent from above, it still
  // is.
  add(8, 9, 10, 11);
  CHECK(voids_in() == 0);
  triangles.erase(triangles.end() - 4); // half of the wall
  CHECK(voids_in() == 0);
}

} // namespace orograph::voids_test
