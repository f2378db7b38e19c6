// SPDX-License-Identifier: GPL-3.0-or-later
// What is left of made grids and TINs between planes of every kind, and cases reckoned by hand.
#include "dem/approximate/tin_of_grid.hpp"
#include "dem/mesh/keep_within.hpp"
#include "dem/mesh/verify_tin.hpp"
#include "dem/tin.hpp"
#include "tests/catch.hpp"
#include "tests/dem/approximate/grid_triangles.hpp"
#include "tests/dem/mesh/check_kept.hpp"
#include "tests/support/made_tin.hpp"
#include "tests/support/notched_tin.hpp"
#include "tests/support/random.hpp"

#include <algorithm>

namespace orograph::keep_within_test {
namespace {

Vec3 any_vertex(const Tin& tin, Random& random) {
  return tin.vertices_m[static_cast<std::size_t>(
      random.whole(0, static_cast<int>(tin.vertices_m.size()) - 1))];
}

// Upright, level or tilted; through anything, a vertex, an edge or a triangle.
HalfSpace any_space(const Tin& tin, Random& random) {
  const auto& [i, j, k] = tin.triangles[static_cast<std::size_t>(
      random.whole(0, static_cast<int>(tin.triangles.size()) - 1))];
  const Vec3 a = tin.vertices_m[i], b = tin.vertices_m[j], c = tin.vertices_m[k];
  const double sign = random.pick({1.0, -1.0});
  Vec3 normal{random.between(-1, 1), random.between(-1, 1), 0};
  switch (random.whole(0, 5)) {
  case 0:
    break;
  case 1:
    normal = random.pick({Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{1, 1, 0}});
    break;
  case 2:
    normal = {0, 0, 1};
    break;
  case 3:
    normal.z = random.between(-1, 1);
    break;
  case 4:
    normal = {b.y - a.y, a.x - b.x, 0};
    break; // along an edge
  default:
    normal = cross(b - a, c - a); // along a triangle
  }
  if (normal == Vec3{}) normal = {0, 0, 1};
  normal = sign * normal;
  const double by = random.pick({0.0, 0.0, 0.3});
  return {normal, dot(normal, a + by * (any_vertex(tin, random) - a))};
}

void report(const char* what, const KeptSums& sums) {
  WARN(what << ": " << sums.scenes << " scenes, of " << sums.kept << " something is left, "
            << sums.cut << " cut; " << sums.asked << " points, " << sums.within << " within; "
            << sums.walls << " walls");
  CHECK(sums.kept > sums.scenes / 2);
  CHECK(sums.cut > sums.scenes / 3);
  CHECK(sums.within > sums.asked / 10);
  CHECK(sums.within < sums.asked);
}

std::vector<HalfSpace> any_spaces(const Tin& tin, Random& random) {
  std::vector<HalfSpace> spaces;
  for (int count = random.pick({1, 1, 2, 2, 3}); count > 0; --count)
    spaces.push_back(any_space(tin, random));
  if (spaces.size() == 2 && random.chance(0.5)) { // parallel, as front and back planes are
    spaces[1] = {-1 * spaces[0].normal, 0};
    spaces[1].offset = dot(spaces[1].normal, any_vertex(tin, random));
  }
  return spaces;
}

MadeTin any_wish(Random& random) {
  MadeTin wanted;
  wanted.columns = random.whole(2, 7);
  wanted.rows = random.whole(2, 7);
  wanted.missing = random.pick({0.0, 0.1, 0.4});
  wanted.shuffled = random.chance(0.5);
  wanted.moved = random.pick({0.0, 0.2, 0.24});
  wanted.whole = random.chance(0.4);
  if (random.chance(0.2)) wanted.low_m = wanted.high_m = 5;
  if (random.chance(0.3)) wanted.first_vertex_m = {1e7, -1e7};
  return wanted;
}

} // namespace

TEST_CASE("of a grid there is left what lies between the planes") {
  KeptSums sums;
  for (std::uint64_t seed = 1; seed <= last_seed(1500); ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const Grid grid = any_small_grid(random, 8);
    const Tin tin = tin_of(grid);
    if (tin.triangles.empty()) continue;
    const std::vector<HalfSpace> spaces = any_spaces(tin, random);
    const Tin kept = keep_within(Surface(grid), spaces);
    REQUIRE(kept == keep_within(tin, spaces));
    check_kept(tin, kept, spaces, random, sums);
  }
  report("grids", sums);
}

TEST_CASE("of a TIN there is left what lies between the planes") {
  KeptSums sums;
  for (std::uint64_t seed = 1; seed <= last_seed(1500); ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const Tin tin = made_tin(random, any_wish(random));
    if (tin.triangles.empty()) continue;
    const std::vector<HalfSpace> spaces = any_spaces(tin, random);
    check_kept(tin, keep_within(Surface(tin), spaces), spaces, random, sums);
  }
  report("TINs", sums);
}

TEST_CASE("walls are cut, and so is what stands over them or ends beside them") {
  KeptSums sums;
  for (std::uint64_t seed = 1; seed <= last_seed(3000); ++seed) {
    CAPTURE(seed);
    Random random(seed);
    MadeTin wanted = any_wish(random);
    wanted.walls = random.pick({0.5, 1.0});
    wanted.high_m = 50;
    Tin tin = made_tin(random, wanted);
    if (tin.triangles.empty()) continue;
    if (wanted.whole && random.chance(0.5)) add_notches(tin, random, 0.3);
    REQUIRE_FALSE(verify(tin));
    const std::vector<HalfSpace> spaces = any_spaces(tin, random);
    check_kept(tin, keep_within(tin, spaces), spaces, random, sums);
  }
  report("walls", sums);
  CHECK(sums.walls > sums.scenes);
}

TEST_CASE("small cases, reckoned by hand") {
  // Four cells of 1 m in two rows; heights are columns.
  const Grid grid{3, 3, PlaneLattice{{0, 2}, {1, 0}, {0, -1}},
                  std::vector<double>{0, 1, 2, 0, 1, 2, 0, 1, 2}};
  const auto keep = [&](std::vector<HalfSpace> spaces) { return keep_within(grid, spaces); };
  SECTION("a plane far off leaves everything as it is, or nothing") {
    CHECK(keep({{{1, 0, 0}, 9}}) == tin_of(grid));
    CHECK(keep({}) == tin_of(grid));
    CHECK(keep({{{1, 0, 0}, -1}}) == Tin{});
    CHECK(keep_within(Tin{}, std::vector<HalfSpace>{{{1, 0, 0}, 0}}) == Tin{});
  }
  SECTION("a plane along a column takes what is beyond, and makes no vertex") {
    for (const HalfSpace& space : {HalfSpace{{1, 0, 0}, 1}, HalfSpace{{0, 0, 7}, 7}}) {
      const Tin left = keep({space});
      CHECK(left.vertices_m ==
            std::vector<Vec3>{{0, 2, 0}, {1, 2, 1}, {0, 1, 0}, {1, 1, 1}, {0, 0, 0}, {1, 0, 1}});
      CHECK(left.triangles.size() == 4);
      CHECK_FALSE(verify(left));
    }
  }
  SECTION("a plane that touches a border from beyond leaves nothing, one within it everything") {
    CHECK(keep({{{1, 0, 0}, 0}}) == Tin{});
    CHECK(keep({{{-1, 0, 0}, 0}}) == tin_of(grid));
    CHECK(keep({{{1, 1, 0}, 0}}) == Tin{});
  }
  SECTION("what lies in a plane is kept from either side") {
    CHECK(keep({{{-1, 0, 1}, 0}}) == tin_of(grid));
    CHECK(keep({{{1, 0, -1}, 0}}) == tin_of(grid));
    CHECK(keep({{{1, 0, -1}, 0}, {{-1, 0, 1}, 0}}) == tin_of(grid));
  }
  SECTION("two planes across one cell leave a strip whose new vertices both sides share") {
    const Tin left = keep({{{-1, 0, 0}, -0.25}, {{1, 0, 0}, 0.75}});
    // On three rows and two diagonals, at both planes; and where the second plane meets the edges
    // that split the two pieces with four corners.
    CHECK(left.vertices_m.size() == 12);
    CHECK(left.triangles.size() == 10);
    CHECK_FALSE(verify(left));
    CHECK(std::count_if(left.vertices_m.begin(), left.vertices_m.end(),
                        [](const Vec3& v) { return v.x == 0.25 && v.z == 0.25; }) == 5);
    CHECK(std::count_if(left.vertices_m.begin(), left.vertices_m.end(),
                        [](const Vec3& v) { return v.x == 0.75 && v.z == 0.75; }) == 7);
  }
  SECTION("a triangle cut by three planes") {
    Tin tin{{{0, 0, 0}, {8, 0, 0}, {0, 8, 8}}, {{0, 1, 2}}, {}};
    tin.neighbours = {{kNoTriangle, kNoTriangle, kNoTriangle}};
    const std::vector<HalfSpace> corners{{{1, 0, 0}, 6}, {{0, 0, 1}, 6}, {{-1, -1, 0}, -2}};
    const Tin left = keep_within(tin, corners);
    CHECK_FALSE(verify(left));
    CHECK(plan_area_m2(left) == 32 - 2 - 2 - 2);
    for (const Vec3& corner :
         {Vec3{6, 0, 0}, Vec3{6, 2, 2}, Vec3{2, 6, 6}, Vec3{0, 6, 6}, Vec3{0, 2, 2}, Vec3{2, 0, 0}})
      CHECK(std::count(left.vertices_m.begin(), left.vertices_m.end(), corner) == 1);
  }
}

TEST_CASE("triangles almost as thin as rounding, seen from above, are cut to a valid TIN") {
  std::size_t kept = 0;
  for (std::uint64_t seed = 1; seed <= last_seed(2000); ++seed) {
    CAPTURE(seed);
    Random random(seed);
    MadeTin wanted = any_wish(random);
    wanted.first_vertex_m = {};
    wanted.walls = random.pick({0.0, 0.5});
    Tin tin = made_tin(random, wanted);
    if (tin.triangles.empty()) continue;
    const double thin = std::ldexp(1, -random.whole(20, 55)), by = random.pick({0.0, 0.0, 3.3});
    for (Vec3& v : tin.vertices_m) v.y = v.y * thin + by * v.x; // exact where by is 0
    if (verify(tin)) continue;
    const Tin left = keep_within(tin, any_spaces(tin, random));
    if (left.triangles.empty()) continue;
    ++kept;
    const auto fault = verify(left);
    INFO((fault ? fault->what : ""));
    REQUIRE_FALSE(fault);
  }
  CHECK(kept > enough(200));
}

TEST_CASE("a needle alone is cut to a valid TIN or leaves nothing") {
  std::size_t kept = 0, nothing = 0;
  for (std::uint64_t seed = 1; seed <= last_seed(3000); ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const double thin = std::ldexp(1, -random.whole(40, 54));
    const auto vertex = [&] {
      const double x = random.between(0, 100);
      return Vec3{x, 0.7 * x + thin * random.between(-99, 99), random.pick({0.0, x})};
    };
    Tin tin{{vertex(), vertex(), vertex()}, {{0, 1, 2}}, {}};
    tin.neighbours = neighbours_by_sorting(tin.triangles);
    if (verify(tin)) continue;
    const Tin left = keep_within(tin, any_spaces(tin, random));
    ++(left.triangles.empty() ? nothing : kept);
    if (!left.triangles.empty()) REQUIRE_FALSE(verify(left));
  }
  CHECK(kept > enough(100));
  CHECK(nothing > enough(100));
}

} // namespace orograph::keep_within_test
