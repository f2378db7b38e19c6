// SPDX-License-Identifier: GPL-3.0-or-later
// The nearest of scattered points, of points on a small lattice and of one point many times, by
// looking at all that are left.
#include "draw/point_tree.hpp"
#include "tests/catch.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <tuple>
#include <vector>

namespace orograph::point_tree_test {
namespace {

std::vector<std::uint32_t> by_distance(const std::vector<Vec2>& points,
                                       const std::vector<bool>& is_left, Vec2 to) {
  std::vector<std::tuple<double, std::uint32_t>> all;
  for (std::uint32_t i = 0; i < points.size(); ++i)
    if (is_left[i]) all.emplace_back(dot(points[i] - to, points[i] - to), i);
  std::sort(all.begin(), all.end());
  std::vector<std::uint32_t> numbers;
  for (const auto& [squared, i] : all) numbers.push_back(i);
  return numbers;
}

} // namespace

TEST_CASE("the nearest points are those that are nearest, and then first, of all that are left") {
  const std::uint64_t kSets = last_seed(400);
  std::size_t ties = 0;
  for (std::uint64_t seed = 1; seed <= kSets; ++seed) {
    INFO("seed " << seed);
    Random random(seed);
    const int count = random.pick({0, 1, 2, 8, 9, 17, random.whole(0, 300)});
    const int lattice = random.pick({0, 1, 4, 1000});
    const auto point = [&] {
      return lattice == 1000 ? Vec2{random.between(-5, 5), random.between(0, 300)}
                             : Vec2{1.0 * random.whole(0, lattice), 1.0 * random.whole(0, lattice)};
    };
    std::vector<Vec2> points;
    for (int i = 0; i < count; ++i) points.push_back(point());
    std::vector<bool> is_left(points.size(), true);
    PointTree tree(points);
    for (int step = 0; step <= count; ++step) {
      const Vec2 to = point();
      const std::vector<std::uint32_t> all = by_distance(points, is_left, to);
      const auto nearest = tree.nearest(to);
      REQUIRE(nearest.has_value() == !all.empty());
      if (!all.empty()) REQUIRE(*nearest == all.front());
      if (count > 0) { // left or not
        const auto beside = static_cast<std::uint32_t>(random.whole(0, count - 1));
        const auto from_there = by_distance(points, is_left, points[beside]);
        const auto found_there = tree.nearest_to_point(beside);
        REQUIRE(found_there.has_value() == !from_there.empty());
        if (found_there) REQUIRE(*found_there == from_there.front());
      }
      const auto some = static_cast<std::size_t>(random.whole(0, 12));
      std::vector<std::uint32_t> found{7};
      tree.nearest(to, some, found);
      const std::size_t expected = std::min(some, all.size());
      REQUIRE(std::equal(found.begin(), found.end(), all.begin(),
                         all.begin() + static_cast<std::ptrdiff_t>(expected)));
      if (all.size() > 1 && length(points[all[0]] - to) == length(points[all[1]] - to)) ++ties;
      if (count == 0) break;
      const int gone = random.whole(0, count - 1); // some a second time
      is_left[static_cast<std::size_t>(gone)] = false;
      tree.remove(static_cast<std::uint32_t>(gone));
    }
  }
  CHECK(ties > enough(1000));
}

} // namespace orograph::point_tree_test
