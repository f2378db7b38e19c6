// SPDX-License-Identifier: GPL-3.0-or-later
// What the index finds, and which triangles are neighbours, against a look at every triangle.
#include "dem/mesh/neighbours.hpp"
#include "dem/mesh/tin_index.hpp"
#include "tests/catch.hpp"
#include "tests/support/made_tin.hpp"
#include "tests/support/random.hpp"

#include <cmath>
#include <map>
#include <set>

namespace orograph::tin_index_test {
namespace {

Vec2 ground(const Tin& tin, std::uint32_t vertex) {
  return {tin.vertices_m[vertex].x, tin.vertices_m[vertex].y};
}

Box2 box_of(const Tin& tin, std::size_t triangle) {
  Box2 box;
  for (const std::uint32_t v : tin.triangles[triangle]) box.include(ground(tin, v));
  return box;
}

bool meet(const Box2& a, const Box2& b) {
  return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y;
}

/// Two convex polygons (or lines) meet: no direction across one of their edges has them apart.
bool meet(const std::vector<Vec2>& a, const std::vector<Vec2>& b) {
  const auto apart = [](const std::vector<Vec2>& p, const std::vector<Vec2>& q, Vec2 across) {
    double p_low = HUGE_VAL, p_high = -HUGE_VAL, q_low = HUGE_VAL, q_high = -HUGE_VAL;
    for (const Vec2 v : p) {
      p_low = std::min(p_low, dot(v, across));
      p_high = std::max(p_high, dot(v, across));
    }
    for (const Vec2 v : q) {
      q_low = std::min(q_low, dot(v, across));
      q_high = std::max(q_high, dot(v, across));
    }
    return p_high < q_low || q_high < p_low;
  };
  if (apart(a, b, {1, 0}) || apart(a, b, {0, 1})) return false; // points have no edges
  for (const auto* polygon : {&a, &b})
    for (std::size_t i = 0; i < polygon->size(); ++i) {
      const Vec2 edge = (*polygon)[(i + 1) % polygon->size()] - (*polygon)[i];
      if (apart(a, b, {-edge.y, edge.x}) || apart(a, b, edge)) return false;
    }
  return true;
}

std::vector<Vec2> corners(const Tin& tin, std::size_t triangle) {
  std::vector<Vec2> at;
  for (const std::uint32_t v : tin.triangles[triangle]) at.push_back(ground(tin, v));
  return at;
}

/// Needles in all directions, larger and smaller triangles, walls: anything.
Tin any_triangles(Random& random, int count) {
  Tin tin;
  const double size = random.pick({1.0, 1000.0});
  for (std::uint32_t t = 0; t < static_cast<std::uint32_t>(count); ++t) {
    const double reach = random.pick({0.01, 1.0}) * size;
    const Vec2 first{std::round(random.between(0, size)), std::round(random.between(0, size))};
    for (int k = 0; k < 3; ++k)
      tin.vertices_m.push_back({std::round(first.x + random.between(-reach, reach)),
                                std::round(first.y + random.between(-reach, reach)), 0});
    tin.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
  }
  return tin;
}

void check_index(Random& random, const Tin& tin, double least, double most) {
  const TinIndex index(tin);
  std::vector<std::uint32_t> found{77};
  for (int i = 0; i < 40; ++i) {
    Box2 box;
    const auto place = [&] { return std::round(random.between(least, most)); };
    box.include({place(), place()});
    if (random.chance(0.7)) box.include({place(), place()});
    index.meeting(box, found);
    REQUIRE(std::is_sorted(found.begin(), found.end()));
    REQUIRE(std::adjacent_find(found.begin(), found.end()) == found.end());
    const std::vector<Vec2> rectangle{
        box.low, {box.high.x, box.low.y}, box.high, {box.low.x, box.high.y}};
    for (std::uint32_t t = 0; t < tin.triangles.size(); ++t) {
      const bool is_found = std::binary_search(found.begin(), found.end(), t);
      if (is_found) REQUIRE(meet(box_of(tin, t), box));
      if (meet(corners(tin, t), rectangle)) REQUIRE(is_found);
    }

    const Vec2 from{place(), place()}, to{place(), place()};
    const double slack = random.pick({0.0, 1.0, 30.0});
    index.along(from, to, slack, found);
    REQUIRE(std::is_sorted(found.begin(), found.end()));
    REQUIRE(std::adjacent_find(found.begin(), found.end()) == found.end());
    for (std::uint32_t t = 0; t < tin.triangles.size(); ++t) {
      // A point of the strip: moved off the line by less than the slack.
      const double turn = random.between(0, 7), off = 0.999 * slack;
      const Vec2 by{off * std::cos(turn), off * std::sin(turn)};
      if (meet(corners(tin, t), {from, to}) || meet(corners(tin, t), {from + by, to + by}))
        REQUIRE(std::binary_search(found.begin(), found.end(), t));
    }
  }
}

} // namespace

TEST_CASE("the index finds every triangle that meets a box or a line") {
  for (std::uint64_t seed = 1; seed <= last_seed(150); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    check_index(random, any_triangles(random, random.whole(1, 60)), -200, 1200);
    MadeTin wanted;
    wanted.columns = random.whole(2, 12);
    wanted.rows = random.whole(2, 12);
    wanted.whole = true;
    wanted.missing = 0.1;
    wanted.walls = 0.3;
    const Tin tin = made_tin(random, wanted);
    if (!tin.triangles.empty()) check_index(random, tin, -20, 140);
  }
}

TEST_CASE("the index finds every one of so many triangles that all cores are at work") {
  Random random(7);
  check_index(random, any_triangles(random, 30000), -200, 1200);
}

TEST_CASE("the index takes triangles of any size, and a single wall") {
  const double most = std::numeric_limits<double>::max();
  const double least = std::numeric_limits<double>::denorm_min();
  for (const double size : {most, 1e300, 1e150, 1.0, 1e-300, least}) {
    Tin tin;
    tin.vertices_m = {{-size, -size, 0}, {size, -size, 0}, {0, size, 0}, {0, -size, 5}};
    tin.triangles = {{0, 1, 2}, {0, 3, 2}, {3, 1, 2}};
    const TinIndex index(tin);
    std::vector<std::uint32_t> found;
    index.meeting({{0, 0}, {0, 0}}, found);
    CHECK(found == std::vector<std::uint32_t>{0, 1, 2});
    index.meeting({{-HUGE_VAL, -HUGE_VAL}, {HUGE_VAL, HUGE_VAL}}, found);
    CHECK(found == std::vector<std::uint32_t>{0, 1, 2});
    index.meeting({}, found);
    CHECK(found.empty());
    index.along({0, size}, {0, -size}, 0, found);
    CHECK(found == std::vector<std::uint32_t>{0, 1, 2});
  }
  Tin wall;
  wall.vertices_m = {{3, 4, 0}, {3, 9, 0}, {3, 9, 5}};
  wall.triangles = {{0, 1, 2}};
  const TinIndex index(wall);
  std::vector<std::uint32_t> found;
  index.meeting({{3, 5}, {4, 5}}, found);
  CHECK(found == std::vector<std::uint32_t>{0});
  index.meeting({{3.5, 5}, {4, 5}}, found);
  CHECK(found.empty());
}

TEST_CASE("a fan of needles takes little memory and time") {
  Tin tin;
  tin.vertices_m.push_back({0, 0, 0});
  const std::uint32_t count = 20000;
  for (std::uint32_t i = 0; i <= count; ++i)
    tin.vertices_m.push_back({1000 * std::cos(i * 3e-4), 1000 * std::sin(i * 3e-4), 0});
  for (std::uint32_t i = 0; i < count; ++i) tin.triangles.push_back({0, i + 1, i + 2});
  const TinIndex index(tin);
  std::vector<std::uint32_t> found;
  index.meeting({{900, 0}, {900, 0}}, found);
  CHECK(std::binary_search(found.begin(), found.end(), 0));
}

TEST_CASE("triangles that have an edge in common are neighbours") {
  for (std::uint64_t seed = 1; seed <= last_seed(300); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    // Any triangles on few vertices: edges of one, two and more.
    std::vector<std::array<std::uint32_t, 3>> triangles;
    // The last ones are so many that all cores are at work.
    const bool is_large = seed > 298;
    const int vertices = is_large ? 3000 : random.whole(3, 20),
              count = is_large ? 40000 : random.whole(0, 25);
    while (triangles.size() < static_cast<std::size_t>(count)) {
      std::array<std::uint32_t, 3> t;
      for (std::uint32_t& v : t) v = static_cast<std::uint32_t>(random.whole(0, vertices - 1));
      if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) triangles.push_back(t);
    }
    using Edge = std::set<std::uint32_t>;
    std::map<Edge, std::vector<std::uint32_t>> of_edge;
    for (std::uint32_t t = 0; t < triangles.size(); ++t)
      for (std::size_t k = 0; k < 3; ++k)
        of_edge[{triangles[t][k], triangles[t][(k + 1) % 3]}].push_back(t);

    const Neighbours found = find_neighbours(triangles, static_cast<std::size_t>(vertices));
    REQUIRE(found.of.size() == triangles.size());
    std::size_t crowded = 0;
    for (const auto& [edge, of] : of_edge) crowded += of.size() > 2 ? 1 : 0;
    REQUIRE(found.crowded.size() == crowded);
    for (const auto& crowd : found.crowded) {
      std::vector<std::uint32_t> there;
      for (const auto& [t, k] : crowd) there.push_back(t);
      const auto [a, b] = ends_of(triangles[crowd[0].triangle], crowd[0].side);
      REQUIRE(of_edge[Edge{a, b}] == there);
    }
    for (std::uint32_t t = 0; t < triangles.size(); ++t)
      for (std::size_t k = 0; k < 3; ++k) {
        const auto& of = of_edge[Edge{triangles[t][(k + 1) % 3], triangles[t][(k + 2) % 3]}];
        const std::uint32_t other = of.size() != 2 ? kNoTriangle : of[0] == t ? of[1] : of[0];
        REQUIRE(found.of[t][k] == other);
      }
  }
}

} // namespace orograph::tin_index_test
