// SPDX-License-Identifier: GPL-3.0-or-later
// A stroke's hash is the sum of its points', so a stroke and its reverse have the same. Strokes are
// parted by the highest bits of theirs, and each share is put into a table of its own: open
// addressing with linear probing, small enough for a core's cache.
#include "draw/repeated_strokes.hpp"

#include "geometry/on_all_cores.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <span>

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

std::vector<std::uint64_t> hashes_of(const Layer& layer) {
  constexpr std::size_t kStrokesOfTask = 256;
  std::vector<std::uint64_t> hashes(layer.strokes.size());
  on_all_cores((hashes.size() + kStrokesOfTask - 1) / kStrokesOfTask, [&](std::size_t task) {
    const std::size_t end = std::min(hashes.size(), (task + 1) * kStrokesOfTask);
    for (std::size_t i = task * kStrokesOfTask; i < end; ++i)
      hashes[i] = hash_of(layer.points(layer.strokes[i]));
  });
  return hashes;
}

// Those of the strokes whose hash has these highest bits.
std::vector<std::uint32_t> repeated_of_share(const Layer& layer,
                                             std::span<const std::uint64_t> hashes,
                                             std::uint64_t share, int bits) {
  const auto is_mine = [&](std::uint64_t hash) {
    return bits == 0 || hash >> (64 - bits) == share;
  };
  // A slot is free at 0; the hash's middle tells most strokes apart without looking at points.
  struct Slot {
    std::uint32_t stroke_after, middle;
  };
  const auto mine = static_cast<std::size_t>(std::count_if(hashes.begin(), hashes.end(), is_mine));
  std::vector<Slot> slots(std::bit_ceil(2 * mine + 1));
  const std::size_t mask = slots.size() - 1;
  std::vector<std::uint32_t> repeated;
  for (std::uint32_t i = 0; i < hashes.size(); ++i) {
    if (!is_mine(hashes[i])) continue;
    const auto middle = static_cast<std::uint32_t>(hashes[i] >> 26);
    std::size_t at = hashes[i] & mask;
    const auto is_same = [&](const Slot& slot) {
      return slot.middle == middle && are_equal(layer.points(layer.strokes[i]),
                                                layer.points(layer.strokes[slot.stroke_after - 1]));
    };
    while (slots[at].stroke_after != 0 && !is_same(slots[at])) at = (at + 1) & mask;
    if (slots[at].stroke_after != 0)
      repeated.push_back(i);
    else
      slots[at] = {i + 1, middle};
  }
  return repeated;
}

} // namespace

std::vector<std::uint32_t> repeated_strokes(const Layer& layer) {
  const std::vector<std::uint64_t> hashes = hashes_of(layer);
  // Every share looks through all hashes, so there aren't many.
  constexpr std::size_t kStrokesOfShare = 1U << 16U;
  constexpr int kMostBits = 4;
  const int bits =
      std::min(kMostBits, static_cast<int>(std::bit_width(hashes.size() / kStrokesOfShare)));
  std::vector<std::vector<std::uint32_t>> of_shares(std::size_t{1} << static_cast<unsigned>(bits));
  on_all_cores(of_shares.size(), [&](std::size_t share) {
    of_shares[share] = repeated_of_share(layer, hashes, share, bits);
  });
  std::vector<std::uint32_t> repeated;
  for (const auto& some : of_shares) repeated.insert(repeated.end(), some.begin(), some.end());
  std::sort(repeated.begin(), repeated.end());
  return repeated;
}

} // namespace orograph
