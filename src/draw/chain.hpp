// SPDX-License-Identifier: GPL-3.0-or-later
// Joining pieces into long strokes by the vertices that they share.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace orograph {

/// An end that meets nothing.
constexpr std::uint64_t kLooseEnd = ~std::uint64_t{0};

/// The vertices at both ends of a piece, `kLooseEnd` where it ends in between.
struct ChainLink {
  std::uint64_t begin, end;
};

/// A piece's place in a chain.
struct ChainedPiece {
  std::uint32_t piece;
  bool turned; ///< walked from its end to its begin
};

/// Runs of pieces.
struct Chains {
  std::vector<ChainedPiece> pieces;
  std::vector<std::uint32_t> ends; ///< of each chain, among the pieces

  std::size_t size() const { return ends.size(); }
  std::span<const ChainedPiece> operator[](std::size_t i) const {
    const std::uint32_t begin = i == 0 ? 0 : ends[i - 1];
    return std::span(pieces).subspan(begin, ends[i] - begin);
  }
};

/// Each piece in just one chain; consecutive pieces share a vertex. At a vertex where more than two
/// meet, they are paired in the order of their numbers. A ring begins at its lowest piece. The same
/// input gives the same chains. Cost O(n) for each 11 bits of the highest vertex.
Chains chain(std::span<const ChainLink> links);

} // namespace orograph
