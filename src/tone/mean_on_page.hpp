// SPDX-License-Identifier: GPL-3.0-or-later
// Sums over the ground that is seen around a place, weighted by how near it is on the page.
#pragma once

#include "geometry/on_all_cores.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "tone/page_columns.hpp"
#include "tone/seen_profiles.hpp"

namespace orograph {

/// Neighbouring columns of a profile that are reckoned together.
constexpr std::size_t kColumnsOfStrip = 32;

/// N values a column of a strip: those of one kind lie one behind the other, so that a processor
/// takes several at once.
template <std::size_t N>
using StripValues = std::array<std::array<float, kColumnsOfStrip>, N>;

/// Of one profile N sums a column: number c of column i is at [c * columns + i].
using SumsOfProfile = std::vector<float>;

/// Of one profile, sums along the line: each is of its own column and `radius` on both sides.
template <std::size_t N>
void sum_along(const SeenProfile& seen, std::size_t radius, SumsOfProfile& sums) {
  const std::size_t width = seen.sight.size();
  thread_local std::vector<float> memory; // asked for once
  memory.resize(N * (width + 1));
  float* const before = memory.data(); // N times, of all columns up to one
  std::array<float, N> sum{};
  for (std::size_t c = 0; c < N; ++c) before[c * (width + 1)] = 0;
  for (std::size_t i = 0; i < width; ++i)
    for (std::size_t c = 0; c < N; ++c) {
      sum[c] += sums[c * width + i];
      before[c * (width + 1) + i + 1] = sum[c];
    }
  for (std::size_t c = 0; c < N; ++c) {
    const float* const up_to = before + c * (width + 1);
    float* const line = sums.data() + c * width;
    const auto take = [&](std::size_t i, std::size_t from, std::size_t to) {
      const float around = up_to[to] - up_to[from];
      line[i] = seen.sight[i] == Sight::none ? 0 : around;
    };
    const std::size_t left = std::min(radius, width), right = width - left;
    for (std::size_t i = 0; i < left; ++i) take(i, 0, std::min(i + radius + 1, width));
    for (std::size_t i = left; i < right; ++i) take(i, i - radius, i + radius + 1);
    for (std::size_t i = std::max(left, right); i < width; ++i) take(i, i - radius, width);
  }
}

/// For each profile, and each column of it, weighted sums over what is seen: up and down the page
/// the weight falls to a third within `reach_mm`, and not beyond where something stands far in
/// front of something else; along the line it is even within it, on both sides. 0 where nothing is
/// seen. `own(profile, first, count, values)` puts into `values` what is summed of `count` columns
/// from `first` on; what it says where nothing is seen doesn't count.
template <std::size_t N, class Own>
std::vector<SumsOfProfile> sums_on_page(std::span<const SeenProfile> seen,
                                        const PageColumns& columns, double reach_mm,
                                        const Own& own) {
  const std::size_t width = columns.count;
  // Memory of one piece would take 10 ms to come, in which nobody looks whether to stop.
  std::vector<SumsOfProfile> sums(seen.size());
  on_all_cores(seen.size(), [&](std::size_t j) { sums[j].resize(N * width); });
  const float reach = static_cast<float>(reach_mm);
  struct Strip {
    StripValues<N> own;
    std::array<float, kColumnsOfStrip> kept; // of the sums over all in front
    std::array<float, kColumnsOfStrip> is_seen;
    bool is_hidden; // all of it; then nothing else is set
  };
  on_all_cores((width + kColumnsOfStrip - 1) / kColumnsOfStrip, [&](std::size_t task) {
    const std::size_t first = task * kColumnsOfStrip,
                      count = std::min(kColumnsOfStrip, width - first);
    thread_local std::vector<Strip> memory; // asked for once
    memory.resize(seen.size());
    Strip* const strips = memory.data();
    StripValues<N> state{};
    for (std::size_t j = 0; j < seen.size(); ++j) {
      Strip& strip = strips[j];
      const Sight* const sight = seen[j].sight.data() + first;
      const float* const gap_mm = seen[j].gap_mm.data() + first;
      strip.is_hidden = std::all_of(sight, sight + count, [](Sight s) { return s == Sight::none; });
      if (strip.is_hidden) continue;
      own(j, first, count, strip.own);
      for (std::size_t k = 0; k < count; ++k) {
        const float way = gap_mm[k] / reach;
        const float of_next = 1 / (1 + way + 0.5F * way * way); // about exp(-way)
        const float of_seen = sight[k] == Sight::first ? 0.0F : of_next;
        strip.kept[k] = sight[k] == Sight::none ? 1.0F : of_seen;
        strip.is_seen[k] = sight[k] == Sight::none ? 0.0F : 1.0F;
      }
      float* const sums_of = sums[j].data() + first;
      for (std::size_t c = 0; c < N; ++c)
        for (std::size_t k = 0; k < count; ++k) {
          strip.own[c][k] = strip.is_seen[k] > 0 ? strip.own[c][k] : 0;
          state[c][k] = state[c][k] * strip.kept[k] + strip.own[c][k];
          sums_of[c * width + k] = strip.is_seen[k] * state[c][k];
        }
    }
    state = {};
    for (std::size_t j = seen.size(); j-- > 0;) {
      const Strip& strip = strips[j];
      if (strip.is_hidden) continue;
      float* const sums_of = sums[j].data() + first;
      for (std::size_t c = 0; c < N; ++c)
        for (std::size_t k = 0; k < count; ++k) {
          sums_of[c * width + k] += strip.is_seen[k] * state[c][k];
          state[c][k] = (state[c][k] + strip.own[c][k]) * strip.kept[k];
        }
    }
  });
  const auto radius = static_cast<std::size_t>(std::lround(reach_mm / columns.mm));
  on_all_cores(seen.size(), [&](std::size_t j) { sum_along<N>(seen[j], radius, sums[j]); });
  return sums;
}

} // namespace orograph
