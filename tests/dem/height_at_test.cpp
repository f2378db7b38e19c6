// SPDX-License-Identifier: GPL-3.0-or-later
// The height at a point against every triangle's barycentric coordinates.
#include "dem/height_at.hpp"
#include "tests/catch.hpp"
#include "tests/support/made_earth_grid.hpp"
#include "tests/support/random.hpp"

#include <algorithm>

namespace orograph::height_at_test {
namespace {

struct Barycentric {
  double least; ///< of the three coordinates: below 0 outside of the triangle
  double height;
};

Barycentric in_triangle(const Grid& grid, const GridTriangle& triangle, Vec2 p) {
  std::array<Vec3, 3> at;
  for (std::size_t k = 0; k < 3; ++k) at[k] = vertex_m(grid, triangle.vertices[k]);
  const auto twice_area = [](Vec2 a, Vec2 b, Vec2 c) { return cross(b - a, c - a); };
  const auto ground = [](Vec3 v) { return Vec2{v.x, v.y}; };
  const Vec2 a = ground(at[0]), b = ground(at[1]), c = ground(at[2]);
  const double all = twice_area(a, b, c);
  const double wa = twice_area(p, b, c) / all, wb = twice_area(a, p, c) / all,
               wc = twice_area(a, b, p) / all;
  return {std::min({wa, wb, wc}), wa * at[0].z + wb * at[1].z + wc * at[2].z};
}

} // namespace

TEST_CASE("the height at a point is that of the triangle that holds it") {
  for (std::uint64_t seed = 1; seed <= last_seed(300); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    GridLattice lattice =
        turned_lattice(random.whole(2, 7), random.whole(2, 7), {10, 13},
                       random.pick({0.0, random.between(-0.7, 0.7)}), random.pick({0.0, 0.4}));
    const double offset = random.pick({0.0, 1e3, 1e6});
    lattice.first_vertex_m = {random.between(-offset, offset), random.between(-offset, offset)};
    GridHeights heights;
    heights.missing = random.pick({0.0, 0.3, 1.0});
    heights.in_double = random.chance(0.5);
    const Grid grid = made_grid(random, lattice, heights);
    const auto triangles = triangles_of(grid);
    // The share of a cell that positions of this size round to, with ten roundings.
    const double rounding = 1e-14 + offset * 1e-15;

    for (int i = 0; i < 50; ++i) {
      const Vec2 p = grid.plane().first_vertex_m +
                     random.between(-0.5, grid.columns - 0.5) * grid.plane().column_step_m +
                     random.between(-0.5, grid.rows - 0.5) * grid.plane().row_step_m;
      const auto found = height_at(grid, p);
      const GridTriangle* holder = nullptr;
      bool on_edge = false;
      for (const GridTriangle& triangle : triangles) {
        const double least = in_triangle(grid, triangle, p).least;
        on_edge = on_edge || std::abs(least) <= rounding;
        if (least > rounding) holder = &triangle;
      }
      if (on_edge) continue;
      CAPTURE(p.x, p.y);
      REQUIRE(found.has_value() == (holder != nullptr));
      if (holder != nullptr)
        REQUIRE(std::abs(*found - in_triangle(grid, *holder, p).height) <= 1000 * rounding);
    }

    std::vector<bool> has_triangle(grid.size(), false);
    for (const GridTriangle& triangle : triangles)
      for (const std::uint32_t vertex : triangle.vertices) has_triangle[vertex] = true;
    for (std::uint32_t i = 0; i < grid.size(); ++i) {
      const Vec3 vertex = vertex_m(grid, i);
      CAPTURE(i);
      const auto found = height_at(grid, {vertex.x, vertex.y});
      REQUIRE(found.has_value() == has_triangle[i]);
      if (found) REQUIRE(*found == vertex.z);
    }
  }
}

TEST_CASE("far outside there is no height, nor at a point that isn't a number") {
  Random random(1);
  const Grid grid = made_grid(random, {3, 3}, {});
  for (const double x : {-1e300, -0.1, 2.1, 1e300, std::nan("")}) {
    CHECK_FALSE(height_at(grid, {x, -1}));
    CHECK_FALSE(height_at(grid, {1, -x}));
  }
}

TEST_CASE(
    "on the ellipsoid all vertices of triangles are on the ground, where LocalFrame has them") {
  std::size_t asked = 0, beside = 0;
  for (std::uint64_t seed = 1; seed <= last_seed(300); ++seed) {
    Random random(seed);
    MadeEarth made = random_earth(random, 8);
    made.lon_step_deg = random.pick({1.0 / 36000, 1.0 / 3600, 0.05}); // 3 m, 30 m, 5 km
    made.lat_step_deg = made.lon_step_deg;
    made.origin_lat_deg = random.between(-80, 80);
    made.north_deg = made.origin_lat_deg + random.between(-2, 2);
    made.west_deg = made.origin_lon_deg + random.between(-2, 2);
    Grid grid = made_earth_grid(random, made);
    // Gentle ground: the same place may be on either side of a vertex that leans.
    std::visit(
        [&](auto& heights) {
          for (auto& h : heights.own()) h = std::isnan(h) ? h : std::fmod(h, decltype(h + 0){1});
        },
        grid.heights_m);
    CAPTURE(seed, made.lon_step_deg, made.origin_lon_deg, made.origin_lat_deg);
    std::vector<bool> has_triangle(grid.size(), false);
    for (const GridTriangle& triangle : triangles_of(grid))
      for (const std::uint32_t vertex : triangle.vertices) has_triangle[vertex] = true;
    const DegreeLattice& degrees = grid.earth().degrees();
    for (int r = 0; r < grid.rows; ++r)
      for (int c = 0; c < grid.columns; ++c) {
        const double height = grid.height_m(c, r) * made.exaggeration;
        if (std::isnan(height)) continue;
        const Vec3 at =
            grid.earth().frame().to_frame(degrees.lon_deg(c), degrees.lat_deg(r), height);
        const auto found = height_at(grid, {at.x, at.y});
        CAPTURE(c, r, at.x, at.y, at.z);
        REQUIRE(found.has_value() == has_triangle[grid.index(c, r)]);
        ++(found ? asked : beside);
        if (found) REQUIRE(std::abs(*found - at.z) <= 1e-6);
      }
  }
  CHECK(asked > enough(3000));
  CHECK(beside > enough(50));
}

} // namespace orograph::height_at_test
