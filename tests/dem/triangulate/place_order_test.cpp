// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/triangulate/place_order.hpp"
#include "tests/catch.hpp"
#include "tests/support/random.hpp"

#include <algorithm>

namespace orograph::place_order_test {
namespace {

// The length of the way through all places in the order.
double way_m(const std::vector<Vec2>& places, const std::vector<std::uint32_t>& order) {
  double sum = 0;
  for (std::size_t k = 1; k < order.size(); ++k)
    sum += length(places[order[k]] - places[order[k - 1]]);
  return sum;
}

void check_order(const std::vector<Vec2>& places) {
  auto order = hilbert_order(places);
  for (std::size_t k = 1; k < order.size(); ++k) {
    const Vec2 here = places[order[k]], before = places[order[k - 1]];
    if (here == before) CHECK(order[k - 1] < order[k]);
    // A place is left once only.
    if (!(here == before))
      CHECK(std::none_of(order.begin() + static_cast<std::ptrdiff_t>(k), order.end(),
                         [&](std::uint32_t i) { return places[i] == before; }));
  }
  std::sort(order.begin(), order.end());
  REQUIRE(order.size() == places.size());
  for (std::uint32_t k = 0; k < order.size(); ++k) REQUIRE(order[k] == k);
}

} // namespace

TEST_CASE("a Hilbert curve visits the cells of a square one beside the other") {
  for (const int side : {2, 4, 8, 32}) {
    std::vector<Vec2> places;
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x) places.push_back({x + 0.5, y + 0.5});
    places.push_back({0, 0}); // the box's corners, so that cells are the curve's
    places.push_back({double(side), double(side)});
    auto order = hilbert_order(places);
    std::erase_if(order, [&](std::uint32_t i) { return i >= unsigned(side * side); });
    CHECK(way_m(places, order) == side * side - 1);
  }
}

TEST_CASE("equal places stand together, and every number is there once") {
  Random random(1);
  for (int round = 0; round < rounds(200); ++round) {
    std::vector<Vec2> places;
    const int count = random.whole(0, 60), side = random.whole(0, 5);
    for (int k = 0; k < count; ++k)
      places.push_back({double(random.whole(0, side)), double(random.whole(0, side))});
    check_order(places);
  }
}

TEST_CASE("clusters smaller than a cell are in order too") {
  Random random(2);
  std::vector<Vec2> places{{1e9, 1e9}, {-1e9, -1e9}};
  for (int k = 0; k < 3000; ++k)
    places.push_back({random.between(0, 1e-9), random.between(0, 1e-9)});
  check_order(places);
  const auto order = hilbert_order(places);
  std::vector<std::uint32_t> cluster;
  for (const std::uint32_t i : order)
    if (i >= 2) cluster.push_back(i);
  // About 0.9 sqrt(places * area) along the curve; at random it would be 0.5 of a side each.
  CHECK(way_m(places, cluster) < 1.2 * std::sqrt(3000.) * 1e-9);

  for (const double tiny : {5e-324, 1e-310, 1e-295})
    check_order({{0, 0}, {tiny, 0}, {0, tiny}, {0, 0}});
}

TEST_CASE("the order of different places doesn't depend on their numbers") {
  Random random(3);
  std::vector<Vec2> places;
  for (int k = 0; k < 500; ++k) places.push_back({random.between(-9, 9), random.between(0, 1e-3)});
  std::vector<Vec2> ordered, again, reversed(places.rbegin(), places.rend());
  for (const std::uint32_t i : hilbert_order(places)) ordered.push_back(places[i]);
  for (const std::uint32_t i : hilbert_order(reversed)) again.push_back(reversed[i]);
  CHECK(ordered == again);
}

} // namespace orograph::place_order_test
