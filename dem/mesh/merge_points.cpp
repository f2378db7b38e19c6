// SPDX-License-Identifier: GPL-3.0-or-later
// A hash table with open addresses: a soup of millions of points is merged in the time that it
// takes to go to memory for each.
#include "dem/mesh/merge_points.hpp"

#include <bit>
#include <cstddef>

namespace orograph {
namespace {

constexpr std::uint32_t none = 0xffffffff;

// Multiplication by an odd number carries low bits upwards; the shift brings them back.
std::uint64_t mixed(std::uint64_t bits) {
  bits *= 0x9e3779b97f4a7c15; // 2^64 / golden ratio (Knuth, volume 3, section 6.4)
  return bits ^ (bits >> 32U);
}

std::uint64_t hash(const Vec3& p) {
  const auto bits = [](double value) { return std::bit_cast<std::uint64_t>(value + 0.0); }; // -0: 0
  return mixed(mixed(mixed(bits(p.x)) ^ bits(p.y)) ^ bits(p.z));
}

} // namespace

std::vector<std::uint32_t> first_equal(std::span<const Vec3> points) {
  std::vector<std::uint32_t> table(std::bit_ceil(2 * points.size() + 1), none);
  std::vector<std::uint32_t> first(points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    std::size_t place = hash(points[i]) & (table.size() - 1);
    while (table[place] != none && points[table[place]] != points[i])
      place = (place + 1) & (table.size() - 1);
    if (table[place] == none) table[place] = i;
    first[i] = table[place];
  }
  return first;
}

} // namespace orograph
