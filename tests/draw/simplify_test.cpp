// SPDX-License-Identifier: GPL-3.0-or-later
// Simplification by its definition: the Hausdorff distance, by dense sampling both ways.
#include "draw/simplify.hpp"
#include "tests/catch.hpp"
#include "tests/draw/to_segment.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace orograph;

namespace {

double to_polyline(Vec2 p, const std::vector<Vec2>& line) {
  double least = line.empty() ? HUGE_VAL : length(p - line.front());
  for (std::size_t i = 0; i + 1 < line.size(); ++i)
    least = std::min(least, to_segment(p, line[i], line[i + 1]));
  return least;
}

// The greatest distance from a point of `from`, its vertices and eight more a segment, to `to`.
double farthest(const std::vector<Vec2>& from, const std::vector<Vec2>& to) {
  double most = 0;
  for (std::size_t i = 0; i < from.size(); ++i)
    for (int k = 0; k < 9; ++k) {
      const Vec2 next = i + 1 < from.size() ? from[i + 1] : from[i];
      most = std::max(most, to_polyline(from[i] + (k / 9.0) * (next - from[i]), to));
    }
  return most;
}

std::vector<Vec2> made_line(Random& random, int kind) {
  std::vector<Vec2> points;
  Vec2 p{random.between(0, 200), random.between(0, 200)};
  const int count = random.whole(0, 60);
  const double step = random.pick({0.001, 0.01, 0.1, 1.0});
  for (int i = 0; i < count; ++i) {
    const double turn = 0.7 * i;
    switch (kind) {
    case 0: // a random walk
      p = p + Vec2{random.between(-step, step), random.between(-step, step)};
      break;
    case 1: // a profile: rightwards
      p = p + Vec2{random.between(0, step), random.between(-0.3, 0.3) * step};
      break;
    case 2: // a zigzag, growing
      p = p + Vec2{step, (i % 2 == 0 ? 1 : -1) * 0.002 * i};
      break;
    case 3: // a spiral
      p = {100 + 0.01 * step * i * std::cos(turn), 100 + 0.01 * step * i * std::sin(turn)};
      break;
    case 4: // along a straight line, forth and back again
      p = p + random.between(-1, 1) * Vec2{step, 0.5 * step};
      break;
    default: // on a coarse lattice, so that points repeat
      p = {std::floor(p.x) + random.whole(-1, 1), std::floor(p.y) + random.whole(0, 1)};
    }
    points.push_back(p);
    if (random.chance(0.1)) points.push_back(p);
  }
  return points;
}

std::vector<Vec2> chosen(const std::vector<Vec2>& points, const std::vector<std::uint32_t>& kept) {
  std::vector<Vec2> line;
  for (const std::uint32_t i : kept) line.push_back(points[i]);
  return line;
}

} // namespace

TEST_CASE("a simplified polyline stays within the tolerance, both ways") {
  for (std::uint64_t seed = 1; seed <= last_seed(3000); ++seed) {
    Random random(seed);
    const int kind = static_cast<int>(seed % 6);
    INFO("seed " << seed << ", kind " << kind);
    const std::vector<Vec2> points = made_line(random, kind);
    const double tolerance = random.pick({0.002, 0.02, 0.5, 3.0});
    std::vector<std::uint32_t> kept{7, 7};
    simplify(points, tolerance, kept);
    REQUIRE(kept.empty() == points.empty());
    if (points.empty()) continue;
    REQUIRE(kept.front() == 0);
    REQUIRE(kept.back() == points.size() - 1);
    for (std::size_t i = 0; i + 1 < kept.size(); ++i) REQUIRE(kept[i] < kept[i + 1]);
    const std::vector<Vec2> line = chosen(points, kept);
    // Coordinates up to 300 and their differences are right to 6e-14.
    REQUIRE(farthest(points, line) <= tolerance + 1e-12);
    REQUIRE(farthest(line, points) <= tolerance + 1e-12);
  }
}

TEST_CASE("points hardly farther from the start than the tolerance hold a line as well") {
  std::size_t left_out = 0;
  for (std::uint64_t seed = 1; seed <= last_seed(20000); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    std::vector<Vec2> points{{0, 0}};
    double distance = 1;
    for (int i = random.whole(2, 6); i > 0; --i) {
      distance += random.between(0, 0.15);
      const double angle = random.between(-1.6, 1.6);
      points.push_back({distance * std::cos(angle), distance * std::sin(angle)});
    }
    std::vector<std::uint32_t> kept;
    simplify(points, 1, kept);
    REQUIRE(farthest(points, chosen(points, kept)) <= 1 + 1e-12);
    left_out += points.size() - kept.size();
  }
  REQUIRE(left_out > enough(20000));
}

TEST_CASE("no tolerance keeps every point") {
  Random random(4);
  for (const double tolerance : {0.0, -1.0}) {
    const std::vector<Vec2> points = made_line(random, 5);
    std::vector<std::uint32_t> kept;
    simplify(points, tolerance, kept);
    REQUIRE(kept.size() == points.size());
    for (std::uint32_t i = 0; i < kept.size(); ++i) REQUIRE(kept[i] == i);
  }
}

TEST_CASE("few points are kept where few are needed") {
  std::vector<Vec2> straight, circle;
  for (int i = 0; i < 1000; ++i) {
    straight.push_back({0.1 * i, 0.03 * i + (i % 2 == 0 ? 0.009 : -0.009)});
    const double turn = 2 * std::numbers::pi * i / 999;
    circle.push_back({100 + 50 * std::cos(turn), 100 + 50 * std::sin(turn)});
  }
  std::vector<std::uint32_t> kept;
  simplify(straight, 0.02, kept);
  CHECK(kept == std::vector<std::uint32_t>{0, 999});
  // A chord that stays within the tolerance of an arc spans 2 acos(1 - tolerance / radius): 111 of
  // them make the circle.
  simplify(circle, 0.02, kept);
  CHECK(kept.size() < 2 * 111);
  CHECK(kept.size() > 111);
}

TEST_CASE("a spike back along the line is kept") {
  std::vector<std::uint32_t> kept;
  simplify(std::vector<Vec2>{{0, 0}, {10, 0}, {5, 0}, {20, 0}}, 0.02, kept);
  CHECK(kept == std::vector<std::uint32_t>{0, 1, 2, 3});
  simplify(std::vector<Vec2>{{0, 0}, {10, 0}, {-3, 0}}, 0.02, kept);
  CHECK(kept == std::vector<std::uint32_t>{0, 1, 2});
}
