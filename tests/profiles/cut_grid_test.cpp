// SPDX-License-Identifier: GPL-3.0-or-later
// The cut against its definition: every triangle cut by the plane on its own.
#include "profiles/cut_grid.hpp"
#include "tests/catch.hpp"
#include "tests/profiles/triangle_cuts.hpp"
#include "tests/support/made_grid.hpp"
#include "tests/support/random.hpp"

#include <limits>

namespace orograph::cut_grid_test {
namespace {

const TriangleSet no_level;

double depth_of(const Grid& grid, const View& view, int column, int row) {
  const Vec3 p = vertex_m(grid, grid.columns * static_cast<std::uint32_t>(row) +
                                    static_cast<std::uint32_t>(column));
  return dot(Vec2{p.x, p.y} - view.depth_origin_m, view.forward);
}

// The nearest and the farthest depth, some through vertices or a rounding beside them, some
// anywhere, and some outside.
std::vector<double> interesting_depths(Random& random, const Grid& grid, const View& view,
                                       const GridCutter& cutter) {
  const double near = cutter.nearest_m(), far = cutter.farthest_m();
  std::vector<double> depths{near, far, std::nextafter(near, far), std::nextafter(far, near)};
  for (int i = 0; i < 4; ++i) {
    const double vertex =
        depth_of(grid, view, random.whole(0, grid.columns - 1), random.whole(0, grid.rows - 1));
    depths.insert(depths.end(), {vertex, std::nextafter(vertex, near), std::nextafter(vertex, far),
                                 random.between(near, far)});
  }
  depths.push_back(near - 1);
  depths.push_back(far + 1);
  return depths;
}

TriangleSet some_level(Random& random, const Grid& grid) {
  TriangleSet level(grid_triangle_count(grid));
  for (const GridTriangle& t : triangles_of(grid))
    if (random.chance(0.5)) level.add(grid_triangle(grid, t.column, t.row, t.half));
  return level;
}

// Positions are numbers up to `reach`; a crossing takes about a dozen roundings of such numbers.
double tolerance_of(const Grid& grid, const View& view) {
  double reach = 1;
  for (const int column : {0, grid.columns - 1})
    for (const int row : {0, grid.rows - 1}) {
      const Vec2 at = grid.plane().position_m(column, row);
      reach = std::max({reach, length(at), length(at - view.depth_origin_m)});
    }
  return 16 * std::numeric_limits<double>::epsilon() * reach;
}

// Whether the plane grazes the near end of a grid whose vertices there, by rounding, aren't all at
// one depth, or lies beyond the corners that tell the cutter where the grid ends. Then what only
// touches the plane from behind, and should be there, is left out.
bool grazes(const Grid& grid, const View& view, const GridCutter& cutter, double depth,
            double tolerance) {
  const double behind = depth - cutter.nearest_m(), before = cutter.farthest_m() - depth;
  if (behind < 0 || before < 0) return std::min(behind, before) >= -tolerance;
  if (behind == 0 || behind > 2 * tolerance) return false; // both depths are rounded
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column)
      if (depth_of(grid, view, column, row) == depth) return true;
  return false;
}

void check_cuts(Random& random, const Grid& grid, const View& view) {
  const TriangleSet level = random.chance(0.5) ? some_level(random, grid) : TriangleSet();
  const GridCutter cutter(grid, view, level);
  Profile profile;
  for (const double depth : interesting_depths(random, grid, view, cutter)) {
    cutter.cut(depth, profile);
    const double tolerance = tolerance_of(grid, view);
    CAPTURE(depth - cutter.nearest_m(), cutter.farthest_m() - depth);
    CAPTURE(depth, grid.columns, grid.rows, view.forward.x, view.forward.y);
    REQUIRE(profile.depth_m == depth);
    const TriangleCuts expected = cut_by_triangles(grid, view, level, depth);
    if (grazes(grid, view, cutter, depth, tolerance))
      REQUIRE(false_vertex_of(profile, expected, tolerance) == "");
    else
      REQUIRE(fault_of(profile, expected, tolerance) == "");
  }
}

GridHeights random_heights(Random& random) {
  GridHeights heights;
  heights.missing = random.pick({0.0, 0.0, 0.05, 0.3, 0.7});
  heights.whole = random.chance(0.5);
  heights.in_double = random.chance(0.5);
  heights.high = random.pick({1.0, 3.0, 100.0});
  return heights;
}

} // namespace

TEST_CASE("a grid is cut as its triangles are, from any azimuth") {
  for (std::uint64_t seed = 1; seed <= last_seed(1500); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    GridLattice lattice = turned_lattice(
        random.whole(2, 9), random.whole(2, 9), {random.between(0.5, 30), random.between(0.5, 30)},
        random.pick({0.0, 0.0, 0.785398163397448, random.between(-0.7, 0.7)}),
        random.chance(0.3) ? random.between(-0.9, 0.9) : 0);
    const double offset = random.pick({0.0, 0.0, 100.0, 1e7});
    lattice.first_vertex_m = {random.between(-1, 1) * offset, random.between(-1, 1) * offset};
    const Grid grid = made_grid(random, lattice, random_heights(random));
    const Angle azimuth =
        Angle::degrees(random.chance(0.5) ? 45.0 * random.whole(-8, 8) : random.between(0, 360));
    const Vec2 origin =
        random.chance(0.5) ? lattice.first_vertex_m : Vec2{random.between(-offset, offset), offset};
    check_cuts(random, grid,
               looking(direction_of_azimuth(azimuth), origin, random.pick({1.0, 1.5, 2.0})));
  }
}

// Whole-number steps seen along an axis: depths are exact, so planes meet vertices and hold row
// lines, column lines or diagonals exactly, with triangles missing on one side or both.
TEST_CASE("planes through vertices and along edges, exactly") {
  const std::vector<std::pair<Vec2, Vec2>> steps{
      {{1, 0}, {0, -1}}, {{2, 1}, {1, -1}}, {{1, 0}, {-1, -1}}, {{1, 0}, {1, -1}},
      {{1, 1}, {1, -1}}, {{1, 2}, {1, -2}}, {{3, 1}, {-1, -2}}, {{1, 1}, {0, -1}},
      {{1, 0}, {3, -1}}, {{1, 3}, {0, -2}}};
  for (std::uint64_t seed = 1; seed <= last_seed(3000); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    const auto& [column_step, row_step] = steps[seed % steps.size()];
    GridLattice lattice{
        random.pick({2, 2, 3, 5, 8}), random.pick({2, 2, 3, 5, 8}), {}, column_step, row_step};
    lattice.first_vertex_m = {1.0 * random.whole(-9, 9), 1.0 * random.whole(-9, 9)};
    const Grid grid = made_grid(random, lattice, random_heights(random));
    check_cuts(random, grid,
               looking(direction_of_azimuth(Angle::degrees(90.0 * random.whole(0, 3)))));
  }
}

TEST_CASE("the plane through a square grid's corner lies along its diagonal at 45 degrees") {
  Random random(7);
  const double s = std::sqrt(0.5);
  const GridLattice lattice{6, 6, {}, {10, 0}, {0, -10}};
  for (const double sign : {1.0, -1.0}) {
    const Grid grid = made_grid(random, lattice, {});
    const View view = looking({sign * s, sign * s});
    const GridCutter cutter(grid, view, no_level);
    Profile profile;
    cutter.cut(0, profile);
    REQUIRE(profile.size() == 6);
    for (int i = 0; i < 6; ++i) {
      const int at = sign > 0 ? i : 5 - i;
      CHECK(profile.z_m[static_cast<std::size_t>(i)] == grid.height_m(at, at));
    }
  }
}

// A row line, column line or diagonal turned by less than rounding can tell is crossed here and
// there, anywhere, and the plane may enter the grid many times.
TEST_CASE("edges nearly along the plane, so that rounding decides what is near") {
  for (std::uint64_t seed = 1; seed <= last_seed(3000); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    const double turn = random.pick({0.0, 1e-17, 1e-16, 3e-16, 1e-15, 1e-14, 1e-12, 1e-9});
    const bool flat = random.chance(0.5);
    GridLattice lattice = turned_lattice(flat ? random.whole(2, 40) : random.whole(2, 5),
                                         flat ? random.whole(2, 5) : random.whole(2, 40),
                                         {7.3, random.pick({7.3, 11.1})},
                                         random.pick({0.3, -0.2, 0.6, 0.785398163397448, 0.0}));
    const double offset = random.pick({10.0, 1e3, 1e7});
    lattice.first_vertex_m = {random.between(-offset, offset), random.between(-offset, offset)};
    const Vec2 edge = random.pick(
        {lattice.column_step_m, lattice.row_step_m, lattice.column_step_m + lattice.row_step_m});
    const Vec2 along = (random.pick({1.0, -1.0}) / length(edge)) * edge;
    const Grid grid = made_grid(random, lattice, random_heights(random));
    const View view = looking({-along.y + turn * along.x, along.x + turn * along.y},
                              {random.between(-offset, offset), random.between(-offset, offset)});
    check_cuts(random, grid, view);
  }
}

TEST_CASE("the cut is the same from the other side, right to left") {
  for (std::uint64_t seed = 1; seed <= last_seed(500); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    GridLattice lattice = turned_lattice(random.whole(2, 20), random.whole(2, 20), {10, 12},
                                         random.pick({0.0, random.between(-0.7, 0.7)}));
    lattice.first_vertex_m = {random.between(-500, 500), random.between(-500, 500)};
    const Grid grid = made_grid(random, lattice, random_heights(random));
    const TriangleSet level = some_level(random, grid);
    const double azimuth = random.pick({0.0, 45.0, 90.0, 1.0 * random.whole(0, 359)});
    const View view = looking(direction_of_azimuth(Angle::degrees(azimuth)));
    const View opposite = looking(direction_of_azimuth(Angle::degrees(azimuth + 180)));
    REQUIRE(opposite.forward == -1.0 * view.forward);
    const GridCutter cutter(grid, view, level), back(grid, opposite, level);
    Profile profile, turned;
    for (const double depth : interesting_depths(random, grid, view, cutter)) {
      CAPTURE(depth);
      cutter.cut(depth, profile);
      back.cut(-depth, turned);
      REQUIRE(turned.size() == profile.size());
      const std::size_t count = profile.size();
      for (std::size_t i = 0; i < count; ++i) {
        const std::size_t k = count - 1 - i;
        // Crossings a rounding apart are put in order by moving the right one.
        REQUIRE(std::abs(turned.u_m[k] + profile.u_m[i]) <= 1e-12);
        const bool missing = std::isnan(profile.z_m[i]) && std::isnan(turned.z_m[k]);
        REQUIRE((missing || turned.z_m[k] == profile.z_m[i]));
        if (i + 1 < count) REQUIRE(turned.after[k - 1] == profile.after[i]);
      }
      // Sums of the same lengths in another order: a rounding each.
      const double length = length_of(profile);
      REQUIRE(std::abs(length_of(turned) - length) <= 1e-15 * static_cast<double>(count) * length);
    }
  }
}

TEST_CASE("nothing is cut before the grid, behind it, or at a depth that isn't a number") {
  Random random(1);
  const Grid grid = made_grid(random, {3, 3, {}, {1, 0}, {0, -1}}, {});
  const GridCutter cutter(grid, looking({0, 1}), no_level);
  CHECK(cutter.nearest_m() == -2);
  CHECK(cutter.farthest_m() == 0);
  Profile profile;
  for (const double depth : {-2.5, 0.5, std::nan(""), -HUGE_VAL, HUGE_VAL}) {
    cutter.cut(depth, profile);
    CHECK(profile.size() == 0);
  }
}

} // namespace orograph::cut_grid_test
