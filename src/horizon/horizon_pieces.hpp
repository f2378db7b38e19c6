// SPDX-License-Identifier: GPL-3.0-or-later
// Lists of horizon pieces: joining and marking them, and going along them.
#pragma once

#include "horizon/horizon.hpp"

#include <algorithm>

namespace orograph {

/// Whether neighbouring pieces collapse to one.
inline bool continues(const HorizonPiece& left, const HorizonPiece& right) {
  return left.source.id == right.source.id && left.inked == right.inked;
}

/// The order in which occluders of one slab raise a horizon: it tells which of equally high ones
/// stands.
inline bool is_raised_before(const HorizonPiece& a, const HorizonPiece& b) {
  return a.x_begin != b.x_begin ? a.x_begin < b.x_begin : a.source.id < b.source.id;
}

inline void append(Horizon& pieces, const HorizonPiece& piece, bool collapse) {
  if (collapse && !pieces.empty() && continues(pieces.back(), piece))
    pieces.back().x_end = piece.x_end;
  else
    pieces.push_back(piece);
}

/// Marks a part of pieces[at] as inked; what is collapsed stays collapsed.
void ink(Horizon& pieces, std::size_t at, double begin, double end, bool collapse);

/// Goes along pieces, from left to right.
struct PieceCursor {
  const HorizonPiece *at, *end;
  explicit operator bool() const { return at != end; }
  const HorizonPiece& operator*() const { return *at; }
  const HorizonPiece* operator->() const { return at; }
  void operator++() { ++at; }
};

/// From the first piece that reaches to or beyond x. REQUIRES pieces that tile X.
inline PieceCursor pieces_from(const Horizon& horizon, double x) {
  const HorizonPiece* first = horizon.data();
  const HorizonPiece* end = first + horizon.size();
  return {
      std::partition_point(first, end, [&](const HorizonPiece& piece) { return piece.x_end < x; }),
      end};
}

} // namespace orograph
