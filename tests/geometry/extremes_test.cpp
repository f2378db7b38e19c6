// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/blocked_points.hpp"
#include "tests/catch.hpp"
#include "tests/support/random.hpp"

#include <limits>

using namespace orograph;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

} // namespace

TEST_CASE("the greatest value over blocks is that over all points, looking at few") {
  std::size_t looked_at = 0, all = 0;
  for (std::uint64_t seed = 1; seed <= last_seed(300); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    std::vector<std::vector<Vec3>> blocks(static_cast<std::size_t>(random.whole(0, 40)));
    BlockedPoints points;
    for (auto& block : blocks) {
      const Vec3 low{random.between(-50, 50), random.between(0, 50), random.between(0, 5)};
      Box3 box;
      for (int i = random.whole(1, 20); i > 0; --i) {
        block.push_back(low +
                        Vec3{random.between(0, 5), random.between(0, 5), random.between(0, 5)});
        box.include(block.back());
      }
      points.boxes.push_back(box);
    }
    points.points = [&](std::size_t i) {
      ++looked_at;
      return std::span<const Vec3>(blocks[i]);
    };
    all += blocks.size();
    const double near = random.pick({-1.0, 3.0, 100.0});
    const auto quotient = [&](Vec3 p) {
      return p.y + near > 0 ? (p.x - 2 * p.z) / (p.y + near) : infinity;
    };
    double expected = -infinity;
    for (const auto& block : blocks)
      for (const Vec3& p : block) expected = std::max(expected, quotient(p));
    REQUIRE(greatest(points, quotient) == expected);

    // In groups, and with a point known beforehand.
    const std::size_t looked_at_alone = looked_at;
    for (std::size_t i = 0; i < blocks.size(); ++i) {
      if (i == 0 || random.chance(0.2)) points.groups.emplace_back();
      points.groups.back().add(i, points.boxes[i]);
    }
    REQUIRE(greatest(points, quotient) == expected);
    if (blocks.empty()) continue;
    Extreme known;
    const auto& some =
        blocks[static_cast<std::size_t>(random.whole(0, static_cast<int>(blocks.size()) - 1))];
    known.take(quotient, some.front());
    // A bound may tell no more than that there is nothing greater.
    const auto over_corners = [&](const Box3& box, double best) {
      double most = -infinity;
      for (int i = 0; i < 8; ++i) most = std::max(most, quotient(corner_of(box, i)));
      return most <= best ? best : most;
    };
    const Extreme found = greatest(points, quotient, over_corners, known);
    REQUIRE(found.value == expected);
    REQUIRE(quotient(found.at) == expected);
    looked_at = looked_at_alone;
  }
  REQUIRE(looked_at < all / 3);
}

TEST_CASE("of a large block the points are found among many") {
  for (std::uint64_t seed = 1; seed <= last_seed(100); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    std::vector<Vec3> block;
    BlockedPoints points;
    points.boxes.emplace_back();
    for (int i = random.whole(1, 1000); i > 0; --i) {
      block.push_back({random.between(0, 5), 0.01 * i, random.between(0, 5)});
      points.boxes[0].include(block.back());
    }
    points.points = [&](std::size_t) { return std::span<const Vec3>(block); };
    double expected = -infinity;
    const auto height = [](Vec3 p) { return p.z - 0.5 * p.x + p.y; };
    for (const Vec3& p : block) expected = std::max(expected, height(p));
    REQUIRE(greatest(points, height) == expected);
  }
}
