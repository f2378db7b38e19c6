// SPDX-License-Identifier: GPL-3.0-or-later
// Open addressing with linear probing; a stroke's hash is the sum of its points', so a stroke and
// its reverse meet in one slot.
#include "draw/stroke_set.hpp"

#include "geometry/on_all_cores.hpp"

#include <algorithm>
#include <bit>

namespace orograph {
namespace {

// Every bit of a coordinate reaches every bit, by odd multipliers (those of MurmurHash3's finalizer
// and the golden ratio's).
std::uint64_t hash_of(Vec2 p) {
  std::uint64_t hash = std::bit_cast<std::uint64_t>(p.x) * 0x9e3779b97f4a7c15ULL;
  hash = (hash ^ (hash >> 32) ^ std::bit_cast<std::uint64_t>(p.y)) * 0xff51afd7ed558ccdULL;
  return (hash ^ (hash >> 32)) * 0xc4ceb9fe1a85ec53ULL;
}

std::uint64_t hash_of(std::span<const Vec2> points) {
  std::uint64_t sum = 0;
  for (const Vec2 p : points) sum += hash_of(p);
  return sum ^ (sum >> 32);
}

bool are_equal(std::span<const Vec2> a, std::span<const Vec2> b) {
  return std::ranges::equal(a, b) || std::equal(a.begin(), a.end(), b.rbegin(), b.rend());
}

} // namespace

StrokeSet::StrokeSet(const Layer& layer)
    : layer_(layer), hashes_(layer.strokes.size()),
      slots_(std::bit_ceil(2 * layer.strokes.size() + 1)) {
  constexpr std::size_t kStrokesOfTask = 256;
  const std::size_t count = hashes_.size();
  on_all_cores((count + kStrokesOfTask - 1) / kStrokesOfTask, [&](std::size_t task) {
    const std::size_t end = std::min(count, (task + 1) * kStrokesOfTask);
    for (std::size_t i = task * kStrokesOfTask; i < end; ++i)
      hashes_[i] = hash_of(layer.points(layer.strokes[i]));
  });
}

bool StrokeSet::insert(std::uint32_t stroke_number) {
  const std::span<const Vec2> points = layer_.points(layer_.strokes[stroke_number]);
  const std::size_t mask = slots_.size() - 1;
  for (std::size_t slot = hashes_[stroke_number] & mask;; slot = (slot + 1) & mask) {
    if (slots_[slot] == 0) {
      slots_[slot] = stroke_number + 1;
      return true;
    }
    if (are_equal(points, layer_.points(layer_.strokes[slots_[slot] - 1]))) return false;
  }
}

} // namespace orograph
