// SPDX-License-Identifier: GPL-3.0-or-later
// From files' triangles to a Tin: what a valid Tin comes back as after being stored as files do,
// and what is refused.
#include "dem/mesh/tin_from_triangles.hpp"
#include "dem/mesh/verify_tin.hpp"
#include "geometry/error.hpp"
#include "tests/catch.hpp"
#include "tests/support/made_tin.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

namespace orograph::tin_from_triangles_test {
namespace {

TriangleSoup soup_of(const Tin& tin) {
  return {tin.vertices_m, tin.triangles};
}

/// Every triangle with points of its own, as STL has them.
TriangleSoup with_own_points(const Tin& tin) {
  TriangleSoup soup;
  for (const auto& triangle : tin.triangles) {
    const auto first = static_cast<std::uint32_t>(soup.points_m.size());
    for (const std::uint32_t v : triangle) soup.points_m.push_back(tin.vertices_m[v]);
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  return soup;
}

std::string what_is_wrong(const TriangleSoup& soup, bool repair = false) {
  try {
    tin_from_triangles(soup, repair, "hill.off");
  } catch (const Error& error) {
    return error.what();
  }
  return "nothing";
}

/// Each triangle by its corners' places, whichever way it runs.
std::multiset<std::array<std::array<double, 3>, 3>> places(const Tin& tin) {
  std::multiset<std::array<std::array<double, 3>, 3>> all;
  for (const auto& triangle : tin.triangles) {
    std::array<std::array<double, 3>, 3> at;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& v = tin.vertices_m[triangle[k]];
      at[k] = {v.x, v.y, v.z};
    }
    std::sort(at.begin(), at.end());
    all.insert(at);
  }
  return all;
}

MadeTin any(Random& random) {
  MadeTin wanted;
  wanted.columns = random.whole(2, 8);
  wanted.rows = random.whole(2, 8);
  wanted.whole = random.chance(0.5);
  wanted.missing = random.pick({0.0, 0.1, 0.5});
  wanted.walls = random.pick({0.0, 0.6});
  wanted.shuffled = random.chance(0.5);
  return wanted;
}

bool is_wall(const Tin& tin, const std::array<std::uint32_t, 3>& t) {
  const Vec3 normal = cross(tin.vertices_m[t[1]] - tin.vertices_m[t[0]],
                            tin.vertices_m[t[2]] - tin.vertices_m[t[0]]);
  return normal.z == 0;
}

} // namespace

TEST_CASE("a valid TIN comes back whichever way its triangles are turned") {
  for (std::uint64_t seed = 1; seed <= last_seed(500); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    MadeTin wanted = any(random);
    wanted.missing = 0; // every wall has a neighbour then, and so one direction
    const Tin tin = made_tin(random, wanted);
    TriangleSoup soup = soup_of(tin);
    std::size_t turned = 0;
    for (auto& triangle : soup.triangles)
      if (random.chance(0.5)) {
        std::swap(triangle[1], triangle[2]);
        turned += is_wall(tin, triangle) ? 0 : 1;
      }
    const TinFromTriangles found = tin_from_triangles(soup, random.chance(0.5), "hill.off");
    REQUIRE_FALSE(verify(found.tin));
    REQUIRE(found.tin == tin);
    REQUIRE(found.notes.size() == (turned > 0 ? 1 : 0));
    if (turned > 1)
      REQUIRE(found.notes[0] ==
              std::to_string(turned) + " triangles ran clockwise seen from above and were turned.");
  }
}

TEST_CASE("repeated points are merged, triangles without area dropped, unused points left out") {
  for (std::uint64_t seed = 1; seed <= last_seed(500); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    const Tin tin = made_tin(random, any(random));
    if (tin.triangles.empty()) continue;
    TriangleSoup soup = with_own_points(tin);
    const auto points = static_cast<std::uint32_t>(soup.points_m.size());
    soup.triangles.push_back({0, 1, 0});
    soup.points_m.insert(soup.points_m.end(), {{1, 2, 4}, {2, 4, 8}, {-1, -2, -4}});
    soup.triangles.push_back({points, points + 1, points + 2});
    const TinFromTriangles found = tin_from_triangles(soup, false, "hill.off");
    REQUIRE_FALSE(verify(found.tin));
    REQUIRE(places(found.tin) == places(tin));
    REQUIRE(found.tin.vertices_m.size() == tin.vertices_m.size());
    REQUIRE(found.tin.triangles.size() == tin.triangles.size());
    for (std::size_t i = 0; i < tin.triangles.size(); ++i) // order stays
      REQUIRE(found.tin.vertices_m[found.tin.triangles[i][0]] ==
              tin.vertices_m[tin.triangles[i][0]]);
    REQUIRE(found.notes.back() == "2 triangles have no area and were dropped.");
  }
}

TEST_CASE("points at 0 and -0 are one") {
  const TriangleSoup soup{
      {{0, 0, 0}, {5, 0, 0}, {0, 5, 0}, {-0.0, -0.0, -0.0}, {0, 5, -0.0}, {-5, 0, 0}},
      {{0, 1, 2}, {3, 4, 5}}};
  const Tin tin = tin_from_triangles(soup, false, "hill.off").tin;
  CHECK(tin.vertices_m.size() == 4);
  CHECK(tin.neighbours == std::vector<std::array<std::uint32_t, 3>>{{kNoTriangle, 1, kNoTriangle},
                                                                    {kNoTriangle, kNoTriangle, 0}});
}

TEST_CASE("triangles that aren't a terrain are refused, by their numbers in the file") {
  TriangleSoup soup{{{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {0, 9, 0}, {2, 1, 5}, {6, 1, 5}, {6, 3, 5}},
                    {{0, 0, 1}, {0, 1, 2}, {0, 3, 2}, {4, 5, 6}}};
  CHECK(what_is_wrong(soup) ==
        "hill.off isn't a terrain, triangles 1 and 3 overlap seen from above (counted from 0): one "
        "height at each place; `repair` keeps what is seen from above");
  CHECK(what_is_wrong(soup, true) == "nothing");
  soup.triangles[3] = {2, 1, 0}; // the first again, which a third has an edge with
  CHECK(what_is_wrong(soup).starts_with(
      "hill.off isn't a terrain, triangles 1, 2 and 3 have one edge in common"));
  CHECK(what_is_wrong(soup, true) == "nothing");
  soup.triangles = {{0, 1, 2}, {0, 1, 3}};
  CHECK(what_is_wrong(soup).starts_with(
      "hill.off isn't a terrain, triangles 0 and 1 run the same way along their common edge"));
  CHECK(what_is_wrong(soup, true) == "nothing");
}

TEST_CASE("coordinates that aren't numbers, and nothing with an area, are refused") {
  TriangleSoup soup{{{0, 0, 0}, {9, 0, 0}, {9, 9, 0}}, {{0, 1, 2}}};
  soup.points_m[1].z = std::nan("");
  CHECK(what_is_wrong(soup) ==
        "hill.off: point 1 (counted from 0) is at 9, 0, nan: coordinates are "
        "finite numbers");
  soup.points_m[1] = {18, 18, 0};
  CHECK(what_is_wrong(soup) == "hill.off has no triangle with an area: a TIN has at least one");
  CHECK(what_is_wrong({}) == "hill.off has no triangle with an area: a TIN has at least one");
}

TEST_CASE("coordinates of any size that aren't repaired are fine") {
  for (const double size : {1e-300, 1e150, 1e300}) {
    TriangleSoup soup{{{0, 0, 0}, {size, 0, 0}, {0, size, 0}, {size, size, 0}}, {{0, 1, 2}}};
    CHECK(what_is_wrong(soup) == "nothing");
    soup.triangles.push_back({0, 1, 3});
    const bool small = size < 1;
    CHECK(what_is_wrong(soup, true) ==
          (small ? "nothing"
                 : "hill.off has coordinates beyond 1e100, too large to repair: coordinates are "
                   "metres near the terrain"));
  }
}

TEST_CASE("walls take the direction that reaches them through other walls") {
  // Steps: level, up, level, up again in two courses, level; everything turned at random.
  for (std::uint64_t seed = 1; seed <= last_seed(50); ++seed) {
    Random random(seed);
    TriangleSoup soup;
    const std::vector<Vec2> outline{{0, 0}, {4, 0}, {4, 3}, {7, 5}, {7, 9}}; // y is height
    for (const Vec2 p : outline)
      for (const double y : {0.0, 6.0}) soup.points_m.push_back({p.x, y, p.y});
    soup.points_m.insert(soup.points_m.end(), {{7, 0, 12}, {7, 6, 12}, {9, 0, 12}, {9, 6, 12}});
    for (std::uint32_t i = 0; i + 2 < soup.points_m.size(); i += 2) {
      soup.triangles.push_back({i, i + 2, i + 3});
      soup.triangles.push_back({i, i + 3, i + 1});
    }
    const auto right = soup.triangles;
    for (auto& triangle : soup.triangles)
      if (random.chance(0.5)) std::swap(triangle[1], triangle[2]);
    const Tin tin = tin_from_triangles(soup, false, "steps.off").tin;
    CHECK(tin.triangles == right);
    CHECK_FALSE(verify(tin));
  }
}

} // namespace orograph::tin_from_triangles_test
