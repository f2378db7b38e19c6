// SPDX-License-Identifier: GPL-3.0-or-later
// Open addressing with linear probing; a stroke is hashed from the end that comes first by its
// coordinates, so a stroke and its reverse meet in one slot.
#include "draw/stroke_set.hpp"

#include <algorithm>
#include <bit>

namespace orograph {
namespace {

bool comes_first(Vec2 a, Vec2 b) {
  return a.x < b.x || (a.x == b.x && a.y < b.y);
}

bool is_hashed_forwards(std::span<const Vec2> points) {
  for (std::size_t i = 0, j = points.size() - 1; i < j; ++i, --j)
    if (points[i] != points[j]) return comes_first(points[i], points[j]);
  return true;
}

// The finalizer of MurmurHash3 over a running sum: every bit of a coordinate reaches every slot.
std::uint64_t mixed(std::uint64_t hash, double coordinate) {
  hash = (hash ^ std::bit_cast<std::uint64_t>(coordinate)) * 0xff51afd7ed558ccdULL;
  hash = (hash ^ (hash >> 33)) * 0xc4ceb9fe1a85ec53ULL;
  return hash ^ (hash >> 33);
}

std::uint64_t hash_of(std::span<const Vec2> points) {
  std::uint64_t hash = points.size();
  const auto add = [&](Vec2 p) { hash = mixed(mixed(hash, p.x), p.y); };
  if (is_hashed_forwards(points))
    for (const Vec2 p : points) add(p);
  else
    std::for_each(points.rbegin(), points.rend(), add);
  return hash;
}

bool are_equal(std::span<const Vec2> a, std::span<const Vec2> b) {
  return std::ranges::equal(a, b) || std::equal(a.begin(), a.end(), b.rbegin(), b.rend());
}

} // namespace

StrokeSet::StrokeSet(const Layer& layer, std::size_t capacity)
    : layer_(layer), slots_(std::bit_ceil(2 * capacity + 1)) {}

bool StrokeSet::insert(std::uint32_t stroke_number) {
  const std::span<const Vec2> points = layer_.points(layer_.strokes[stroke_number]);
  const std::size_t mask = slots_.size() - 1;
  for (std::size_t slot = hash_of(points) & mask;; slot = (slot + 1) & mask) {
    if (slots_[slot] == 0) {
      slots_[slot] = stroke_number + 1;
      return true;
    }
    if (are_equal(points, layer_.points(layer_.strokes[slots_[slot] - 1]))) return false;
  }
}

} // namespace orograph
