// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/catch.hpp"
#include "tests/support/random.hpp"
#include "view/extremes.hpp"

#include <limits>

using namespace orograph;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

} // namespace

TEST_CASE("the greatest value over blocks is that over all points, looking at few") {
  std::size_t looked_at = 0, all = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
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
  }
  REQUIRE(looked_at < all / 3);
}
