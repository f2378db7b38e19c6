// SPDX-License-Identifier: GPL-3.0-or-later
// What is left between planes, against its definition: each triangle of the surface cut by each
// plane, in long double.
#include "dem/approximate/tin_of_grid.hpp"
#include "dem/mesh/keep_within.hpp"
#include "dem/mesh/verify_tin.hpp"
#include "dem/plan_area.hpp"
#include "tests/catch.hpp"
#include "tests/dem/approximate/grid_triangles.hpp"
#include "tests/support/half_spaces.hpp"
#include "tests/support/made_tin.hpp"
#include "tests/support/notched_tin.hpp"

#include <algorithm>
#include <set>

using namespace orograph;

namespace {

struct Sums {
  std::size_t scenes = 0, kept = 0, cut = 0, asked = 0, within = 0, walls = 0;
};

double scale_m(const Tin& tin) {
  double greatest = 1;
  for (const Vec3& v : tin.vertices_m)
    greatest = std::max({greatest, std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  return greatest;
}

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

std::vector<LongPoint> corners(const Tin& tin, std::size_t t) {
  std::vector<LongPoint> points;
  for (const std::uint32_t v : tin.triangles[t]) points.push_back(long_point(tin.vertices_m[v]));
  return points;
}

void check_areas(const Tin& tin, std::span<const HalfSpace> spaces, const Tin& kept, double band) {
  Areas expected, got;
  long double doubtful = 0, length = 0;
  for (std::size_t t = 0; t < tin.triangles.size(); ++t) {
    const std::vector<LongPoint> whole = corners(tin, t);
    const Areas part = areas_of(part_within(whole, spaces));
    expected.in_plan += part.in_plan;
    expected.in_space += part.in_space;
    for (const HalfSpace& space : spaces)
      if (std::all_of(whole.begin(), whole.end(),
                      [&](LongPoint p) { return std::abs(metres_beyond(space, p)) < band; }))
        doubtful += areas_of(whole).in_space;
    for (std::size_t k = 0; k < 3; ++k) {
      const LongPoint p = whole[k], q = whole[(k + 1) % 3];
      length += std::hypot(p.x - q.x, p.y - q.y, p.z - q.z);
    }
  }
  for (std::size_t t = 0; t < kept.triangles.size(); ++t) {
    const Areas part = areas_of(corners(kept, t));
    got.in_plan += part.in_plan;
    got.in_space += part.in_space;
  }
  CAPTURE(static_cast<double>(expected.in_space), static_cast<double>(got.in_space));
  REQUIRE(std::abs(expected.in_plan - got.in_plan) <= band * length + doubtful);
  REQUIRE(std::abs(expected.in_space - got.in_space) <= band * length + doubtful);
}

// By more than `band` outside of an edge: below 0; inside of all: above 0.
int place_in(const Tin& tin, std::size_t t, LongPoint p, long double band) {
  const std::vector<LongPoint> c = corners(tin, t);
  if (areas_of(c).in_plan <= 0) return -1;
  bool inside = true;
  for (std::size_t k = 0; k < 3; ++k) {
    const LongPoint a = c[k], b = c[(k + 1) % 3];
    const long double left =
        ((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x)) / std::hypot(b.x - a.x, b.y - a.y);
    if (left < -band) return -1;
    inside = inside && left > band;
  }
  return inside ? 1 : 0;
}

long double height_at(const Tin& tin, std::size_t t, LongPoint p) {
  const std::vector<LongPoint> c = corners(tin, t);
  const auto twice = [&](LongPoint a, LongPoint b) {
    return (a.x - p.x) * (b.y - p.y) - (a.y - p.y) * (b.x - p.x);
  };
  const long double u = twice(c[1], c[2]), v = twice(c[2], c[0]), w = twice(c[0], c[1]);
  return (u * c[0].z + v * c[1].z + w * c[2].z) / (u + v + w);
}

// Points of the old surface are there or not; and points of the kept one were.
void check_points(const Tin& tin, std::span<const HalfSpace> spaces, const Tin& kept, double band,
                  Random& random, Sums& sums) {
  const auto any_point = [&](const Tin& of, std::size_t t) {
    const auto& [i, j, k] = of.triangles[t];
    const double a = random.between(0.05, 0.55), b = random.between(0.05, 0.4);
    const Vec3 o = of.vertices_m[i];
    return o + a * (of.vertices_m[j] - o) + b * (of.vertices_m[k] - o);
  };
  const auto covering = [&](const Tin& of, LongPoint p) {
    int most = -1;
    for (std::size_t t = 0; t < of.triangles.size(); ++t) {
      const int place = place_in(of, t, p, band);
      if (place > 0) REQUIRE(std::abs(height_at(of, t, p) - p.z) <= 50 * band);
      most = std::max(most, place);
    }
    return most;
  };
  for (std::size_t t = 0; t < tin.triangles.size(); ++t) {
    const LongPoint p = long_point(any_point(tin, t));
    if (place_in(tin, t, p, 4 * band) <= 0) continue;
    const long double by = metres_beyond(spaces, p);
    if (std::abs(by) <= 4 * band) continue;
    ++sums.asked;
    sums.within += by < 0;
    const int place = covering(kept, p);
    REQUIRE((by < 0 ? place >= 0 : place <= 0));
  }
  for (std::size_t t = 0; t < kept.triangles.size(); ++t) {
    for (const LongPoint p : corners(kept, t)) REQUIRE(metres_beyond(spaces, p) <= band);
    const LongPoint p = long_point(any_point(kept, t));
    if (place_in(kept, t, p, 4 * band) <= 0) continue;
    REQUIRE(covering(tin, p) >= 0);
  }
}

long double distance(LongPoint p, LongPoint a, LongPoint b) {
  const long double x = b.x - a.x, y = b.y - a.y, z = b.z - a.z;
  const long double along =
      ((p.x - a.x) * x + (p.y - a.y) * y + (p.z - a.z) * z) / (x * x + y * y + z * z);
  const long double s = std::clamp(along, 0.0L, 1.0L);
  return std::hypot(a.x + s * x - p.x, a.y + s * y - p.y, a.z + s * z - p.z);
}

// New border lies on planes: pieces share their vertices.
void check_border(const Tin& tin, std::span<const HalfSpace> spaces, const Tin& kept, double band) {
  std::vector<std::array<LongPoint, 2>> border;
  for (std::size_t t = 0; t < tin.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k)
      if (tin.neighbours[t][k] == kNoTriangle)
        border.push_back({corners(tin, t)[(k + 1) % 3], corners(tin, t)[(k + 2) % 3]});
  for (std::size_t t = 0; t < kept.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      if (kept.neighbours[t][k] != kNoTriangle) continue;
      const LongPoint p = corners(kept, t)[(k + 1) % 3], q = corners(kept, t)[(k + 2) % 3];
      const bool cut = std::any_of(spaces.begin(), spaces.end(), [&](const HalfSpace& space) {
        return std::abs(metres_beyond(space, p)) <= band &&
               std::abs(metres_beyond(space, q)) <= band;
      });
      const bool old = std::any_of(border.begin(), border.end(), [&](const auto& edge) {
        return distance(p, edge[0], edge[1]) <= band && distance(q, edge[0], edge[1]) <= band;
      });
      CAPTURE(t, k);
      REQUIRE((cut || old));
    }
}

// Triangles well within are there as they were, in their order, and their vertices in theirs.
void check_kept(const Tin& tin, std::span<const HalfSpace> spaces, const Tin& kept, double band) {
  const auto key = [](const Tin& of, std::size_t t) {
    const auto& [i, j, k] = of.triangles[t];
    return std::array{of.vertices_m[i], of.vertices_m[j], of.vertices_m[k]};
  };
  bool walls = false;
  for (std::size_t t = 0; t < tin.triangles.size(); ++t)
    walls = walls || areas_of(corners(tin, t)).in_plan == 0;
  std::size_t next = 0;
  std::vector<std::array<std::uint32_t, 2>> numbers; // of vertices: old and new
  for (std::size_t t = 0; t < tin.triangles.size(); ++t) {
    const auto c = corners(tin, t);
    if (std::any_of(c.begin(), c.end(),
                    [&](LongPoint p) { return metres_beyond(spaces, p) > -band; }))
      continue;
    std::size_t found = next;
    while (found < kept.triangles.size() && key(kept, found) != key(tin, t)) ++found;
    if (walls && found == kept.triangles.size()) continue; // beside a wall that is cut
    REQUIRE(found < kept.triangles.size());
    next = found + 1;
    for (std::size_t k = 0; k < 3; ++k)
      numbers.push_back({tin.triangles[t][k], kept.triangles[found][k]});
  }
  std::sort(numbers.begin(), numbers.end());
  for (std::size_t i = 1; i < numbers.size(); ++i) {
    if (numbers[i][0] == numbers[i - 1][0])
      REQUIRE(numbers[i][1] == numbers[i - 1][1]);
    else
      REQUIRE(numbers[i][1] > numbers[i - 1][1]);
  }
}

void check(const Tin& tin, const Tin& kept, std::span<const HalfSpace> spaces, Random& random,
           Sums& sums) {
  const double band = 1e-12 * scale_m(tin);
  ++sums.scenes;
  sums.kept += !kept.triangles.empty();
  sums.cut += !kept.triangles.empty() && kept.triangles.size() != tin.triangles.size();
  for (std::size_t t = 0; t < kept.triangles.size(); ++t)
    sums.walls += areas_of(corners(kept, t)).in_plan == 0;
  if (!kept.triangles.empty()) {
    const auto fault = verify(kept);
    INFO((fault ? fault->what : ""));
    REQUIRE_FALSE(fault);
  }
  std::set<std::uint32_t> used;
  for (const auto& triangle : kept.triangles) used.insert(triangle.begin(), triangle.end());
  REQUIRE(used.size() == kept.vertices_m.size());
  check_areas(tin, spaces, kept, 20 * band);
  check_points(tin, spaces, kept, 20 * band, random, sums);
  check_border(tin, spaces, kept, 20 * band);
  check_kept(tin, spaces, kept, 20 * band);
}

void report(const char* what, const Sums& sums) {
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
  Sums sums;
  for (std::uint64_t seed = 1; seed <= 1500; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const Grid grid = any_small_grid(random, 8);
    const Tin tin = tin_of(grid);
    if (tin.triangles.empty()) continue;
    const std::vector<HalfSpace> spaces = any_spaces(tin, random);
    const Tin kept = keep_within(Surface(grid), spaces);
    REQUIRE(kept == keep_within(tin, spaces));
    check(tin, kept, spaces, random, sums);
  }
  report("grids", sums);
}

TEST_CASE("of a TIN there is left what lies between the planes") {
  Sums sums;
  for (std::uint64_t seed = 1; seed <= 1500; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const Tin tin = made_tin(random, any_wish(random));
    if (tin.triangles.empty()) continue;
    const std::vector<HalfSpace> spaces = any_spaces(tin, random);
    check(tin, keep_within(Surface(tin), spaces), spaces, random, sums);
  }
  report("TINs", sums);
}

TEST_CASE("walls are cut, and so is what stands over them or ends beside them") {
  Sums sums;
  for (std::uint64_t seed = 1; seed <= 3000; ++seed) {
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
    check(tin, keep_within(tin, spaces), spaces, random, sums);
  }
  report("walls", sums);
  CHECK(sums.walls > sums.scenes);
}

TEST_CASE("small cases, reckoned by hand") {
  // Four cells of 1 m in two rows; heights are columns.
  const Grid grid{3, 3, {0, 2}, {1, 0}, {0, -1}, std::vector<double>{0, 1, 2, 0, 1, 2, 0, 1, 2}};
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
  for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
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
  CHECK(kept > 200);
}
