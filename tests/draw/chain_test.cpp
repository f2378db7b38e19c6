// SPDX-License-Identifier: GPL-3.0-or-later
#include "draw/chain.hpp"
#include "tests/catch.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <map>

using namespace orograph;

namespace {

std::uint64_t entry_of(const std::vector<ChainLink>& links, const ChainedPiece& piece) {
  return piece.turned ? links[piece.piece].end : links[piece.piece].begin;
}
std::uint64_t exit_of(const std::vector<ChainLink>& links, const ChainedPiece& piece) {
  return piece.turned ? links[piece.piece].begin : links[piece.piece].end;
}

void check_chains(const std::vector<ChainLink>& links, const Chains& chains) {
  std::vector<int> used(links.size(), 0);
  for (std::size_t c = 0; c < chains.size(); ++c) {
    const auto pieces = chains[c];
    REQUIRE(!pieces.empty());
    for (const ChainedPiece& piece : pieces) ++used[piece.piece];
    for (std::size_t i = 0; i + 1 < pieces.size(); ++i) {
      const std::uint64_t shared = exit_of(links, pieces[i]);
      REQUIRE(shared != kLooseEnd);
      REQUIRE(shared == entry_of(links, pieces[i + 1]));
    }
  }
  REQUIRE(std::all_of(used.begin(), used.end(), [](int times) { return times == 1; }));

  // As long as can be: of the ends at a vertex at most one isn't joined to another there. A ring
  // joins its own two ends.
  std::map<std::uint64_t, int> ends;
  for (std::size_t c = 0; c < chains.size(); ++c) {
    const auto pieces = chains[c];
    const std::uint64_t first = entry_of(links, pieces.front()),
                        last = exit_of(links, pieces.back());
    if (first == last) continue;
    ++ends[first];
    ++ends[last];
  }
  ends.erase(kLooseEnd);
  for (const auto& [vertex, count] : ends) REQUIRE(count == 1);
}

bool same(const Chains& a, const Chains& b) {
  return a.ends == b.ends &&
         std::equal(a.pieces.begin(), a.pieces.end(), b.pieces.begin(), b.pieces.end(),
                    [](const ChainedPiece& x, const ChainedPiece& y) {
                      return x.piece == y.piece && x.turned == y.turned;
                    });
}

// By the definition of their pairs: at each vertex, with a map.
std::map<std::uint32_t, std::uint32_t> paired_ends(const std::vector<ChainLink>& links) {
  std::map<std::uint64_t, std::uint32_t> waiting;
  std::map<std::uint32_t, std::uint32_t> pairs;
  for (std::uint32_t end = 0; end < 2 * links.size(); ++end) {
    const std::uint64_t vertex = end % 2 == 0 ? links[end / 2].begin : links[end / 2].end;
    if (vertex == kLooseEnd) continue;
    const auto [other, is_first] = waiting.emplace(vertex, end);
    if (is_first) continue;
    pairs[end] = other->second;
    pairs[other->second] = end;
    waiting.erase(other);
  }
  return pairs;
}

} // namespace

TEST_CASE("chains hold every piece once and go on at shared vertices, as far as they can") {
  for (std::uint64_t seed = 1; seed <= last_seed(3000); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    const int vertices = random.pick({1, 3, 10, 60});
    // Vertex numbers of every size.
    const std::uint64_t apart = random.pick<std::uint64_t>({1, 97, 2048, 4096001, 1ULL << 57U});
    std::vector<ChainLink> links;
    for (int i = random.whole(0, 40); i > 0; --i) {
      const auto end = [&] {
        return random.chance(0.15) ? kLooseEnd
                                   : apart * static_cast<std::uint64_t>(random.whole(0, vertices));
      };
      links.push_back({end(), end()});
    }
    const Chains chains = chain(links);
    check_chains(links, chains);
    const auto pairs = paired_ends(links);
    for (std::size_t c = 0; c < chains.size(); ++c)
      for (std::size_t i = 0; i + 1 < chains[c].size(); ++i) {
        const ChainedPiece from = chains[c][i], to = chains[c][i + 1];
        REQUIRE(pairs.at(2 * from.piece + (from.turned ? 0 : 1)) ==
                2 * to.piece + (to.turned ? 1 : 0));
      }
    REQUIRE(same(chains, chain(links)));
  }
}

TEST_CASE("an outline in scattered pieces is one ring from its lowest piece") {
  const std::vector<ChainLink> links{{kLooseEnd, kLooseEnd}, {3, 4}, {1, 2}, {3, 2}, {1, 4}};
  const Chains chains = chain(links);
  REQUIRE(chains.size() == 2);
  CHECK(chains[0].size() == 1);
  REQUIRE(chains[1].size() == 4);
  CHECK(chains[1][0].piece == 1);
  CHECK_FALSE(chains[1][0].turned);
  CHECK(chains[1][1].piece == 4);
  CHECK(chains[1][1].turned);
  check_chains(links, chains);
}

TEST_CASE("where two lines cross at a vertex, pieces are paired by their numbers") {
  const std::vector<ChainLink> links{{1, 9}, {9, 2}, {3, 9}, {9, 4}};
  const Chains chains = chain(links);
  REQUIRE(chains.size() == 2);
  CHECK(chains[0][0].piece == 0);
  CHECK(chains[0][1].piece == 1);
  CHECK(chains[1][0].piece == 2);
  CHECK(chains[1][1].piece == 3);
}
