// SPDX-License-Identifier: GPL-3.0-or-later
#include "draw/chain.hpp"

#include "geometry/on_all_cores.hpp"
#include "geometry/sort_by_number.hpp"

namespace orograph {
namespace {

// End number 2 * piece is the piece's begin, 2 * piece + 1 its end.
constexpr std::uint32_t kNone = ~std::uint32_t{0};

struct EndAtVertex {
  std::uint64_t vertex;
  std::uint32_t end;
};

std::vector<std::uint32_t> partners_of(std::span<const ChainLink> links) {
  std::vector<EndAtVertex> ends;
  ends.reserve(2 * links.size());
  for (std::uint32_t piece = 0; piece < links.size(); ++piece) {
    throw_if_stopped(piece);
    if (links[piece].begin != kLooseEnd) ends.push_back({links[piece].begin, 2 * piece});
    if (links[piece].end != kLooseEnd) ends.push_back({links[piece].end, 2 * piece + 1});
  }
  sort_by_number(ends, [](const EndAtVertex& end) { return end.vertex; });
  std::vector<std::uint32_t> partner(2 * links.size(), kNone);
  std::size_t step = 0;
  for (std::size_t i = 0; i + 1 < ends.size();) {
    throw_if_stopped(step++);
    if (ends[i].vertex != ends[i + 1].vertex) {
      ++i;
      continue;
    }
    partner[ends[i].end] = ends[i + 1].end;
    partner[ends[i + 1].end] = ends[i].end;
    i += 2;
  }
  return partner;
}

} // namespace

Chains chain(std::span<const ChainLink> links) {
  const std::vector<std::uint32_t> partner = partners_of(links);
  std::vector<bool> used(links.size(), false);
  Chains chains;
  chains.pieces.reserve(links.size());
  const auto walk = [&](std::uint32_t entry) {
    while (entry != kNone && !used[entry / 2]) {
      throw_if_stopped(chains.pieces.size());
      used[entry / 2] = true;
      chains.pieces.push_back({entry / 2, entry % 2 == 1});
      entry = partner[entry ^ 1U];
    }
    chains.ends.push_back(static_cast<std::uint32_t>(chains.pieces.size()));
  };
  for (std::uint32_t end = 0; end < partner.size(); ++end) {
    throw_if_stopped(end);
    if (partner[end] == kNone && !used[end / 2]) walk(end);
  }
  for (std::uint32_t end = 0; end < partner.size(); end += 2) {
    throw_if_stopped(end);
    if (!used[end / 2]) walk(end); // what is left are rings
  }
  return chains;
}

} // namespace orograph
