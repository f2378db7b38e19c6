// SPDX-License-Identifier: GPL-3.0-or-later
// The last round has three quarters of the places, scattered, the one before it three quarters of
// the rest, and so on, so that a line or a curve of places can't make every insertion rebuild most
// of what is there (Amenta, Choi and Rote 2003).
#include "dem/triangulate/insertion_order.hpp"

#include "dem/mesh/orientation.hpp"

#include <algorithm>
#include <array>
#include <bit>

namespace orograph {
namespace {

constexpr int kRounds = 12; // the first with about a sixteen-millionth of the places

// Numbers in which the bits of neighbouring ones have nothing to do with each other (the mixer of
// Steele, Lea and Flood 2014, splitmix64).
std::uint64_t scattered(std::uint64_t number) {
  number += 0x9e3779b97f4a7c15;
  number = (number ^ (number >> 30U)) * 0xbf58476d1ce4e5b9;
  number = (number ^ (number >> 27U)) * 0x94d049bb133111eb;
  return number ^ (number >> 31U);
}

} // namespace

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
}

} // namespace orograph
