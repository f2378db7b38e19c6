// SPDX-License-Identifier: GPL-3.0-or-later
<<<<<<< HEAD
#include "dem/insertion_order.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
=======
// The last round has three quarters of the places, scattered, the one before it three quarters of
// the rest, and so on, so that a line or a curve of places can't make every insertion rebuild most
// of what is there (Amenta, Choi and Rote 2003).
#include "dem/insertion_order.hpp"

#include "dem/orientation.hpp"

#include <algorithm>
#include <array>
#include <bit>
>>>>>>> 05555c7237a44eb17743dcbcea3a2ef224aaada9

namespace orograph {
namespace {

<<<<<<< HEAD
std::uint64_t spread(std::uint32_t bits) { // a zero before each bit
  std::uint64_t x = bits;
  x = (x | x << 16) & 0x0000ffff0000ffff;
  x = (x | x << 8) & 0x00ff00ff00ff00ff;
  x = (x | x << 4) & 0x0f0f0f0f0f0f0f0f;
  x = (x | x << 2) & 0x3333333333333333;
  x = (x | x << 1) & 0x5555555555555555;
  return x;
}

// Along the Z-shaped curve.
std::uint64_t place_on_curve(LatticePoint point) {
  return spread(static_cast<std::uint32_t>(point.column)) |
         spread(static_cast<std::uint32_t>(point.row)) << 1;
}

// The more zeros a number without pattern ends in, the earlier.
int round_before_last(std::uint64_t place) {
  place = (place ^ place >> 31) * 0x9e3779b97f4a7c15;
  place = (place ^ place >> 29) * 0xbf58476d1ce4e5b9;
  return std::countr_zero((place ^ place >> 32) | std::uint64_t{1} << 40);
=======
constexpr int kRounds = 12; // the first with about a sixteen-millionth of the places

// Numbers in which the bits of neighbouring ones have nothing to do with each other (the mixer of
// Steele, Lea and Flood 2014, splitmix64).
std::uint64_t scattered(std::uint64_t number) {
  number += 0x9e3779b97f4a7c15;
  number = (number ^ (number >> 30U)) * 0xbf58476d1ce4e5b9;
  number = (number ^ (number >> 27U)) * 0x94d049bb133111eb;
  return number ^ (number >> 31U);
>>>>>>> 05555c7237a44eb17743dcbcea3a2ef224aaada9
}

} // namespace

<<<<<<< HEAD
std::vector<LatticePoint> insertion_order(const std::vector<LatticePoint>& points) {
  struct Key {
    int before_last;
    std::uint64_t place;
    LatticePoint point;
  };
  std::vector<Key> keys;
  keys.reserve(points.size());
  for (const LatticePoint& point : points) {
    const std::uint64_t place = place_on_curve(point);
    keys.push_back({round_before_last(place), place, point});
  }
  std::sort(keys.begin(), keys.end(), [](const Key& one, const Key& other) {
    return one.before_last != other.before_last ? one.before_last > other.before_last
                                                : one.place < other.place;
  });
  std::vector<LatticePoint> ordered;
  ordered.reserve(keys.size());
  for (const Key& key : keys) ordered.push_back(key.point);
  return ordered;
=======
std::vector<std::uint32_t> insertion_order(std::span<const Vec2> places) {
  std::uint32_t third = 2;
  while (third < places.size() && orientation(places[0], places[1], places[third]) == 0) ++third;
  if (third >= places.size()) return {};

  // Three quarters go to the last round, three of the rest's to the one before it, and so on.
  std::array<std::vector<std::uint32_t>, kRounds> rounds;
  for (std::uint32_t i = 2; i < places.size(); ++i)
    if (i != third) rounds[std::min(std::countr_zero(scattered(i)) / 2, kRounds - 1)].push_back(i);
  std::vector<std::uint32_t> order{0, 1, third};
  order.reserve(places.size());
  for (int round = kRounds - 1; round >= 0; --round)
    order.insert(order.end(), rounds[round].begin(), rounds[round].end());
  return order;
>>>>>>> 05555c7237a44eb17743dcbcea3a2ef224aaada9
}

} // namespace orograph
