// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/triangulate/place_order.hpp"

#include "dem/triangulate/orientation.hpp"
#include "geometry/box.hpp"
#include "geometry/on_all_cores.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <tuple>
#include <utility>

namespace orograph {
namespace {

constexpr int kLevels = 32; // of the curve: 2^32 cells a side

struct Keyed {
  std::uint64_t key;
  std::uint32_t number;
  bool operator<(const Keyed& other) const {
    return key != other.key ? key < other.key : number < other.number;
  }
};

// How far along the curve a cell is: from the greatest quadrants to the smallest, each turned so
// that the curve enters it where it left the one before.
std::uint64_t along_curve(std::uint32_t x, std::uint32_t y) {
  std::uint64_t along = 0;
  for (int level = kLevels - 1; level >= 0; --level) {
    const std::uint32_t right = (x >> level) & 1U, up = (y >> level) & 1U;
    along = along << 2U | ((3U * right) ^ up);
    if (up) continue;
    if (right) {
      x = ~x;
      y = ~y;
    }
    std::swap(x, y);
  }
  return along;
}

std::uint32_t cell_of(double at, double low, double cells_per_m) {
  constexpr double last = 4294967295.0;
  return static_cast<std::uint32_t>(std::clamp((at - low) * cells_per_m, 0.0, last));
}

// Sorts a range of numbers. Places that share a cell get a curve of their own, over their smaller
// box.
void sort_range(std::span<const Vec2> places, std::span<std::uint32_t> numbers) {
  Box2 box;
  for (const std::uint32_t i : numbers) box.include(places[i]);
  const double side = std::max(box.width(), box.height());
  if (!(side > 1e-290)) { // one place, or several that no scale tells apart
    std::sort(numbers.begin(), numbers.end(), [&](std::uint32_t a, std::uint32_t b) {
      return std::tuple(places[a].x, places[a].y, a) < std::tuple(places[b].x, places[b].y, b);
    });
    return;
  }
  const double cells_per_m = 0x1p32 / side;
  std::vector<Keyed> keyed(numbers.size());
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    throw_if_stopped(k);
    const Vec2 p = places[numbers[k]];
    keyed[k] = {
        along_curve(cell_of(p.x, box.low.x, cells_per_m), cell_of(p.y, box.low.y, cells_per_m)),
        numbers[k]};
  }
  std::size_t steps = 0;
  std::sort(keyed.begin(), keyed.end(), StoppableLess(steps));
  for (std::size_t k = 0; k < keyed.size(); ++k) numbers[k] = keyed[k].number;

  for (std::size_t begin = 0, end = 0; begin < keyed.size(); begin = end) {
    bool same_place = true;
    for (end = begin + 1; end < keyed.size() && keyed[end].key == keyed[begin].key; ++end)
      same_place = same_place && places[numbers[end]] == places[numbers[begin]];
    if (!same_place) sort_range(places, numbers.subspan(begin, end - begin));
  }
}

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

std::vector<std::uint32_t> hilbert_order(std::span<const Vec2> places) {
  std::vector<std::uint32_t> numbers(places.size());
  for (std::uint32_t i = 0; i < numbers.size(); ++i) numbers[i] = i;
  sort_range(places, numbers);
  return numbers;
}

// The last round has three quarters of the places, scattered, the one before it three quarters of
// the rest, and so on, so that a line or a curve of places can't make every insertion rebuild most
// of what is there (Amenta, Choi and Rote 2003).
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
