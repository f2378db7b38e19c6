// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/approximate/lattice_insertion_order.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>

namespace orograph {
namespace {

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
}

} // namespace

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
}

} // namespace orograph
