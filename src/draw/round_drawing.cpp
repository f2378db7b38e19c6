// SPDX-License-Identifier: GPL-3.0-or-later
#include "draw/round_drawing.hpp"

#include "geometry/on_all_cores.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace orograph {

double rounded_to_page_step(double x_mm) {
  constexpr double steps_per_mm = 1e4;
  static_assert(1 / kPageStep_mm == steps_per_mm);
  // From here on doubles are whole numbers, so adding it rounds, ties to even. (Without the
  // instruction for it, which not all processors have, std::nearbyint takes several times as long.)
  constexpr double whole_from = 0x1p52;
  const double steps = x_mm * steps_per_mm;
  const double whole = std::copysign(std::abs(steps) + whole_from - whole_from, steps);
  // Dividing the whole number of steps rounds once, to the double nearest to the decimal;
  // multiplying by 1e-4, itself inexact, would not. Adding 0 turns -0 into 0.
  return whole / steps_per_mm + 0.0;
}

namespace {

bool have_points_in_order(const std::vector<Stroke>& strokes) {
  std::uint32_t end = 0;
  for (const Stroke& stroke : strokes) {
    if (stroke.first_point < end) return false;
    end = stroke.first_point + stroke.point_count;
  }
  return true;
}

void put_points_in_order(Layer& layer) {
  std::vector<Vec2> page_mm;
  std::vector<Vec3> map;
  for (Stroke& stroke : layer.strokes) {
    throw_if_stopped(page_mm.size());
    const auto move = [&](const auto& from, auto& to) {
      if (from.empty()) return;
      const auto first = from.begin() + stroke.first_point;
      to.insert(to.end(), first, first + stroke.point_count);
    };
    const auto first = static_cast<std::uint32_t>(page_mm.size());
    move(layer.page_mm, page_mm);
    move(layer.map, map);
    stroke.first_point = first;
  }
  layer.page_mm = std::move(page_mm);
  layer.map = std::move(map);
}

} // namespace

// In place: `kept_point` and `kept_stroke` follow what is read, never ahead of it.
RoundingCounts round_strokes(Layer& layer) {
  if (!have_points_in_order(layer.strokes)) put_points_in_order(layer);
  RoundingCounts dropped;
  const bool has_map = !layer.map.empty();
  std::size_t step = 0;
  for (Vec2& p : layer.page_mm) {
    throw_if_stopped(step++);
    p = {rounded_to_page_step(p.x), rounded_to_page_step(p.y)};
  }
  std::uint32_t kept_point = 0, kept_stroke = 0;
  for (Stroke stroke : layer.strokes) {
    throw_if_stopped(step++);
    const std::uint32_t first = kept_point, end = stroke.first_point + stroke.point_count;
    bool has_length = false;
    for (std::uint32_t read = stroke.first_point; read < end; ++read) {
      const Vec2 p = layer.page_mm[read];
      const bool moves = kept_point > first && p != layer.page_mm[kept_point - 1];
      has_length = has_length || moves;
      if (kept_point > first && !moves &&
          (!has_map || layer.map[read] == layer.map[kept_point - 1]))
        continue;
      layer.page_mm[kept_point] = p;
      if (has_map) layer.map[kept_point] = layer.map[read];
      ++kept_point;
    }
    stroke.first_point = first;
    stroke.point_count = kept_point - first;
    if (!has_length) {
      ++dropped.empty_strokes;
      kept_point = first;
    } else {
      layer.strokes[kept_stroke++] = stroke;
    }
  }
  dropped.points = layer.page_mm.size() - kept_point;
  layer.strokes.resize(kept_stroke);
  layer.page_mm.resize(kept_point);
  if (has_map) layer.map.resize(kept_point);
  return dropped;
}

namespace {

// A stroke's hash is the sum of its points', so a stroke and its reverse have the same. Strokes are
// parted by the highest bits of theirs, and each share is put into a table of its own: open
// addressing with linear probing, small enough for a core's cache.

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

// What tells strokes with the same points apart. Ink is ink, but a place on the ground may be a
// river and a border.
std::int32_t feature_of(const Layer& layer, const Stroke& stroke) {
  return layer.map.empty() ? -1 : stroke.feature;
}

std::vector<std::uint64_t> hashes_of(const Layer& layer) {
  constexpr std::size_t kStrokesOfTask = 256;
  std::vector<std::uint64_t> hashes(layer.strokes.size());
  on_all_cores((hashes.size() + kStrokesOfTask - 1) / kStrokesOfTask, [&](std::size_t task) {
    const std::size_t end = std::min(hashes.size(), (task + 1) * kStrokesOfTask);
    for (std::size_t i = task * kStrokesOfTask; i < end; ++i) {
      const Stroke& stroke = layer.strokes[i];
      hashes[i] = hash_of(layer.points(stroke)) +
                  0x9e3779b97f4a7c15ULL * static_cast<std::uint64_t>(feature_of(layer, stroke));
    }
  });
  return hashes;
}

// Those among some strokes that are the same as one before it there. `strokes` rise.
std::vector<std::uint32_t> repeated_among(const Layer& layer, std::span<const std::uint64_t> hashes,
                                          std::span<const std::uint32_t> strokes) {
  // A slot is free at 0; the hash's middle tells most strokes apart without looking at points.
  struct Slot {
    std::uint32_t stroke_after, middle;
  };
  std::vector<Slot> slots(std::bit_ceil(2 * strokes.size() + 1));
  const std::size_t mask = slots.size() - 1;
  std::vector<std::uint32_t> repeated;
  for (const std::uint32_t i : strokes) {
    throw_if_stopped(i);
    const auto middle = static_cast<std::uint32_t>(hashes[i] >> 26);
    std::size_t at = hashes[i] & mask;
    const auto is_same = [&](const Slot& slot) {
      if (slot.middle != middle) return false;
      const Stroke &one = layer.strokes[i], &other = layer.strokes[slot.stroke_after - 1];
      return feature_of(layer, one) == feature_of(layer, other) &&
             are_equal(layer.points(one), layer.points(other));
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
  // By their hashes' highest bits: shares for the cores, with slots that stay in their caches.
  constexpr std::size_t kStrokesOfShare = 1U << 16U;
  constexpr int kMostBits = 4;
  const int bits =
      std::min(kMostBits, static_cast<int>(std::bit_width(hashes.size() / kStrokesOfShare)));
  std::vector<std::vector<std::uint32_t>> of_shares(std::size_t{1} << static_cast<unsigned>(bits));
  for (auto& share : of_shares) share.reserve(hashes.size() / of_shares.size() * 9 / 8);
  for (std::uint32_t i = 0; i < hashes.size(); ++i) {
    throw_if_stopped(i);
    of_shares[bits == 0 ? 0 : hashes[i] >> (64 - bits)].push_back(i);
  }
  on_all_cores(of_shares.size(), [&](std::size_t share) {
    of_shares[share] = repeated_among(layer, hashes, of_shares[share]);
  });
  std::vector<std::uint32_t> repeated;
  for (const auto& some : of_shares) repeated.insert(repeated.end(), some.begin(), some.end());
  std::sort(repeated.begin(), repeated.end());
  return repeated;
}

RoundingCounts drop_repeated_strokes(Layer& layer) {
  const std::vector<std::uint32_t> repeated = repeated_strokes(layer);
  RoundingCounts dropped;
  dropped.repeated_strokes = repeated.size();
  if (repeated.empty()) return dropped;
  std::uint32_t points = 0, count = 0;
  const auto move_points = [&](auto& list, const Stroke& stroke) {
    if (list.empty()) return;
    const auto first = list.begin() + stroke.first_point;
    std::copy(first, first + stroke.point_count, list.begin() + points);
  };
  auto next_repeated = repeated.begin();
  for (std::uint32_t i = 0; i < layer.strokes.size(); ++i) {
    throw_if_stopped(i);
    if (next_repeated != repeated.end() && *next_repeated == i) {
      ++next_repeated;
      continue;
    }
    Stroke stroke = layer.strokes[i];
    move_points(layer.page_mm, stroke);
    move_points(layer.map, stroke);
    stroke.first_point = points;
    points += stroke.point_count;
    layer.strokes[count++] = stroke;
  }
  dropped.points = layer.page_mm.size() - points;
  layer.strokes.resize(count);
  layer.page_mm.resize(points);
  if (!layer.map.empty()) layer.map.resize(points);
  return dropped;
}

RoundingCounts round_to_page_step(Layer& layer) {
  RoundingCounts dropped = round_strokes(layer);
  const RoundingCounts repeated = drop_repeated_strokes(layer);
  dropped.points += repeated.points;
  dropped.repeated_strokes = repeated.repeated_strokes;
  return dropped;
}

} // namespace orograph
