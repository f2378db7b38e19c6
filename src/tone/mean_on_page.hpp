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

template <std::size_t N>
using Sums = std::array<float, N>;

/// For each profile, and each column of it, the weighted sums of `own(profile, column)` over what
/// is seen: up and down the page the weight falls to a third within `reach_mm`, and not beyond
/// where something stands far in front of something else; along the line it is even within it, on
/// both sides. 0 where nothing is seen.
template <std::size_t N, class Own>
std::vector<std::vector<Sums<N>>> sums_on_page(std::span<const SeenProfile> seen,
                                               const PageColumns& columns, double reach_mm,
                                               const Own& own) {
  const std::size_t width = columns.count;
  // Memory of one piece would take 10 ms to come, in which nobody looks whether to stop.
  std::vector<std::vector<Sums<N>>> sums(seen.size());
  on_all_cores(seen.size(), [&](std::size_t j) { sums[j].resize(width); });
  const auto add = [](Sums<N>& to, const Sums<N>& some) {
    for (std::size_t c = 0; c < N; ++c) to[c] += some[c];
  };
  constexpr std::size_t kColumnsOfTask = 32;
  on_all_cores((width + kColumnsOfTask - 1) / kColumnsOfTask, [&](std::size_t task) {
    const std::size_t first = task * kColumnsOfTask, end = std::min(first + kColumnsOfTask, width);
    // What is kept of the sums over all in front at a profile.
    const auto kept = [&](std::size_t j, std::size_t i) {
      if (seen[j].sight[i] == Sight::first) return 0.0F;
      const float way = seen[j].gap_mm[i] / static_cast<float>(reach_mm);
      return 1 / (1 + way + 0.5F * way * way); // about exp(-way)
    };
    std::array<Sums<N>, kColumnsOfTask> state{};
    thread_local std::vector<Sums<N>> owns; // asked for once
    thread_local std::vector<float> shares;
    owns.resize(seen.size() * kColumnsOfTask);
    shares.resize(seen.size() * kColumnsOfTask);
    for (std::size_t j = 0; j < seen.size(); ++j)
      for (std::size_t i = first; i < end; ++i) {
        if (seen[j].sight[i] == Sight::none) continue;
        const std::size_t at = j * kColumnsOfTask + (i - first);
        Sums<N>& s = state[i - first];
        shares[at] = kept(j, i);
        for (float& sum : s) sum *= shares[at];
        owns[at] = own(j, i);
        add(s, owns[at]);
        sums[j][i] = s;
      }
    state = {};
    for (std::size_t j = seen.size(); j-- > 0;)
      for (std::size_t i = first; i < end; ++i) {
        if (seen[j].sight[i] == Sight::none) continue;
        const std::size_t at = j * kColumnsOfTask + (i - first);
        Sums<N>& s = state[i - first];
        add(sums[j][i], s);
        add(s, owns[at]);
        for (float& sum : s) sum *= shares[at];
      }
  });
  const auto radius = static_cast<std::size_t>(std::lround(reach_mm / columns.mm));
  on_all_cores(seen.size(), [&](std::size_t j) {
    thread_local std::vector<Sums<N>> before; // of all columns up to one
    before.assign(width + 1, {});
    std::vector<Sums<N>>& line = sums[j];
    for (std::size_t i = 0; i < width; ++i) {
      before[i + 1] = before[i];
      add(before[i + 1], line[i]);
    }
    for (std::size_t i = 0; i < width; ++i) {
      if (seen[j].sight[i] == Sight::none) continue;
      const std::size_t from = i >= radius ? i - radius : 0, to = std::min(i + radius + 1, width);
      for (std::size_t c = 0; c < N; ++c) line[i][c] = before[to][c] - before[from][c];
    }
  });
  return sums;
}

} // namespace orograph
