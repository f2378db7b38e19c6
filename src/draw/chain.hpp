// SPDX-License-Identifier: GPL-3.0-or-later
// Joining pieces into long strokes by the vertices that they share.
#pragma once

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

/// Chains of pieces, each piece in just one of them; consecutive pieces share a vertex. At a vertex
/// where more than two meet, they are paired in the order of their numbers. A ring begins at its
/// lowest piece. The same input gives the same chains. Cost O(n log n).
std::vector<std::vector<ChainedPiece>> chain(std::span<const ChainLink> links);

} // namespace orograph
