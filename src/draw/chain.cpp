// SPDX-License-Identifier: GPL-3.0-or-later
#include "draw/chain.hpp"

#include <algorithm>

namespace orograph {
namespace {

// End number 2 * piece is the piece's begin, 2 * piece + 1 its end.
constexpr std::uint32_t kNone = ~std::uint32_t{0};

std::vector<std::uint32_t> partners_of(std::span<const ChainLink> links) {
  const auto vertex = [&](std::uint32_t end) {
    return end % 2 == 0 ? links[end / 2].begin : links[end / 2].end;
  };
  std::vector<std::uint32_t> ends;
  for (std::uint32_t end = 0; end < 2 * links.size(); ++end)
    if (vertex(end) != kLooseEnd) ends.push_back(end);
  std::sort(ends.begin(), ends.end(), [&](std::uint32_t a, std::uint32_t b) {
    return vertex(a) != vertex(b) ? vertex(a) < vertex(b) : a < b;
  });
  std::vector<std::uint32_t> partner(2 * links.size(), kNone);
  for (std::size_t i = 0; i + 1 < ends.size();) {
    if (vertex(ends[i]) != vertex(ends[i + 1])) {
      ++i;
      continue;
    }
    partner[ends[i]] = ends[i + 1];
    partner[ends[i + 1]] = ends[i];
    i += 2;
  }
  return partner;
}

} // namespace

std::vector<std::vector<ChainedPiece>> chain(std::span<const ChainLink> links) {
  const std::vector<std::uint32_t> partner = partners_of(links);
  std::vector<bool> used(links.size(), false);
  std::vector<std::vector<ChainedPiece>> chains;
  const auto walk = [&](std::uint32_t entry) {
    auto& pieces = chains.emplace_back();
    while (entry != kNone && !used[entry / 2]) {
      used[entry / 2] = true;
      pieces.push_back({entry / 2, entry % 2 == 1});
      entry = partner[entry ^ 1U];
    }
  };
  for (std::uint32_t end = 0; end < partner.size(); ++end)
    if (partner[end] == kNone && !used[end / 2]) walk(end);
  for (std::uint32_t end = 0; end < partner.size(); end += 2)
    if (!used[end / 2]) walk(end); // what is left are rings
  return chains;
}

} // namespace orograph
