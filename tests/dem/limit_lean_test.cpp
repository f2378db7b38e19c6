// SPDX-License-Identifier: GPL-3.0-or-later
// Where the ellipsoid would turn triangles over: vertex by vertex and triangle by triangle, in
// higher precision. Lattices up to far from the frame's origin, with spikes, pits and gaps.
#include "dem/extent.hpp"
#include "dem/limit_lean.hpp"
#include "tests/catch.hpp"
#include "tests/support/made_earth_grid.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <vector>

namespace orograph::limit_lean_test {
namespace {

Grid spiky_grid(Random& random) {
  MadeEarth made = random_earth(random, 40);
  made.lon_step_deg = std::abs(made.lon_step_deg);
  made.lat_step_deg = std::abs(made.lat_step_deg);
  Grid grid = made_earth_grid(random, made);
  const double spike_m = random.pick({0.0, 3000.0, 32767.0, 400000.0});
  const double share = random.pick({0.002, 0.02, 0.5});
  std::visit(
      [&](auto& heights) {
        for (auto& height : heights.own())
          if (random.chance(share)) height += static_cast<float>(random.pick({1, -1}) * spike_m);
      },
      grid.heights_m);
  return grid;
}

std::vector<Vec3> vertices_of(const Grid& grid) {
  std::vector<Vec3> out;
  for (std::size_t i = 0; i < grid.size(); ++i) out.push_back(grid.vertex_m(i));
  return out;
}

bool are_same(double a, double b) {
  return std::memcmp(&a, &b, sizeof a) == 0;
}

// Beyond rounding.
bool is_turned_over(const std::array<Vec3, 3>& t) {
  const long double ux = static_cast<long double>(t[1].x) - t[0].x,
                    uy = static_cast<long double>(t[1].y) - t[0].y,
                    wx = static_cast<long double>(t[2].x) - t[0].x,
                    wy = static_cast<long double>(t[2].y) - t[0].y;
  const long double one = ux * wy, other = uy * wx;
  return one - other < -4e-12L * (std::abs(one) + std::abs(other));
}

std::size_t turned_over(const Grid& grid) {
  std::size_t count = 0;
  for (const GridTriangle& t : triangles_of(grid))
    count += is_turned_over(
        {grid.vertex_m(t.vertices[0]), grid.vertex_m(t.vertices[1]), grid.vertex_m(t.vertices[2])});
  return count;
}

} // namespace

TEST_CASE("where a grid is known to be upright no triangle is turned over, wherever it is") {
  std::size_t known = 0, unknown = 0;
  for (std::uint64_t seed = 1; seed <= last_seed(3000); ++seed) {
    INFO("seed " << seed);
    Random random(seed);
    MadeEarth made;
    made.columns = random.whole(2, 20);
    made.rows = random.whole(2, 20);
    made.lon_step_deg = random.pick({1e-9, 1. / 3600, 0.02, 0.5, 5.0, 15.0});
    made.lat_step_deg = std::min(random.pick({0.3, 1.0, 3.0}) * made.lon_step_deg, 8.0);
    const double high_deg = made.lat_step_deg * (made.rows - 1);
    made.north_deg = random.pick({90.0, -90 + high_deg, random.between(high_deg - 90, 90)});
    made.west_deg = random.between(-180, 180);
    const double away = random.pick({0.0, 1.0, 30.0, 60.0, 180.0});
    made.origin_lon_deg = made.west_deg + random.between(-away, away);
    made.origin_lat_deg = std::clamp(made.north_deg + random.between(-away, away), -90., 90.);
    made.exaggeration = random.pick({1.0, 5.0});
    if (random.chance(0.3)) made.ellipsoid.inverse_flattening = 3;
    Grid grid;
    grid.columns = made.columns;
    grid.rows = made.rows;
    grid.lattice = earth_lattice(made);
    const double rise_m = random.pick({0.0, 1.0, 100.0, 5000.0});
    std::vector<float> heights(grid.size());
    for (float& height : heights) height = static_cast<float>(random.between(-rise_m, rise_m));
    grid.heights_m = std::move(heights);
    const std::size_t turned = extent_of(grid).turned_over;
    limit_lean(grid);
    if (grid.earth().is_upright()) REQUIRE(turned == 0);
    ++(grid.earth().is_upright() ? known : unknown);
  }
  WARN(known << " known, " << unknown << " not");
  CHECK(known > enough(300));
  CHECK(unknown > enough(300));
}

TEST_CASE("no triangle is turned over once the lean is limited") {
  std::size_t limited = 0, vertices = 0, moved = 0, left_alone = 0;
  for (std::uint64_t seed = 1; seed <= last_seed(400); ++seed) {
    INFO("seed " << seed);
    Random random(seed);
    Grid grid = spiky_grid(random);
    const std::vector<Vec3> before = vertices_of(grid);
    const std::size_t were_turned = turned_over(grid);
    limit_lean(grid);
    const LeanLimits* const limits = grid.earth().lean_limits();
    REQUIRE((limits == nullptr) == (were_turned == 0));
    const std::vector<Vec3> after = vertices_of(grid);
    std::size_t aside = 0, other_heights = 0;
    for (std::size_t i = 0; i < before.size(); ++i) {
      other_heights += are_same(before[i].z, after[i].z) ? 0 : 1;
      aside += are_same(before[i].x, after[i].x) && are_same(before[i].y, after[i].y) ? 0 : 1;
    }
    CHECK(other_heights == 0);
    if (!limits) {
      CHECK(aside == 0);
      ++left_alone;
      continue;
    }
    ++limited;
    vertices += before.size();
    moved += aside;
    CHECK(limits->turned_over() == were_turned);
    CHECK(turned_over(grid) == 0);
    // A row at a time, as one by one.
    std::vector<double> heights(static_cast<std::size_t>(grid.columns)), x = heights, y = heights,
                                                                         z = heights;
    for (int row = 0; row < grid.rows; ++row) {
      for (int column = 0; column < grid.columns; ++column)
        heights[static_cast<std::size_t>(column)] = grid.height_m(column, row);
      grid.earth().row_vertices_m(row, 0, heights, x, y, z);
      for (std::size_t c = 0; c < heights.size(); ++c) {
        const Vec3 at = after[static_cast<std::size_t>(row) * heights.size() + c];
        REQUIRE(are_same(at.x, x[c]));
        REQUIRE(are_same(at.y, y[c]));
        REQUIRE(are_same(at.z, z[c]));
      }
    }
  }
  WARN(limited << " grids limited, " << moved << " of their " << vertices << " vertices; "
               << left_alone << " left as they were");
  CHECK(limited > enough(60));
  CHECK(left_alone > enough(60));
}

TEST_CASE("what is far from a spike leans by its height") {
  Random random(1);
  MadeEarth made;
  made.columns = made.rows = 60;
  made.lon_step_deg = made.lat_step_deg = 1 / 3600.0;
  made.origin_lat_deg = 45;
  Grid grid = made_earth_grid(random, made);
  std::vector<double> heights(grid.size());
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column)
      heights[grid.index(column, row)] = 1000 + 5 * column - 3 * row;
  const std::size_t spike = grid.index(31, 28), pit = grid.index(12, 40);
  heights[spike] = 30000;
  heights[pit] = -30000;
  grid.heights_m = heights;
  const std::vector<Vec3> before = vertices_of(grid);
  limit_lean(grid);
  const std::vector<Vec3> after = vertices_of(grid);
  for (std::size_t i = 0; i < before.size(); ++i) {
    const bool is_same = before[i] == after[i];
    CAPTURE(i % 60, i / 60);
    CHECK(is_same == (i != spike && i != pit));
  }
  // It stands where the ground beside it does, to some metres of height of that.
  const Vec3 beside = grid.earth().vertex_m(31, 28, 1000);
  CHECK(std::hypot(after[spike].x - beside.x, after[spike].y - beside.y) < 200 * 0.02);
}

} // namespace orograph::limit_lean_test
