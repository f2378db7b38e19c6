// SPDX-License-Identifier: GPL-3.0-or-later
// The horizon: what the occluders in front reach up to, at each X of the visibility plane.
#pragma once

#include "geometry/segment.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace orograph {

/// The part of a source segment between two abscissae.
struct HorizonPiece {
  double x_begin, x_end;
  Segment source; ///< its line is the height; for the sky see `is_sky`
  bool inked;     ///< a line is drawn along it
  /// No height of it is lower, where that is kept (BlockedHorizon).
  float low = -std::numeric_limits<float>::infinity();
};

/// Source id of the horizon before anything stands: height -infinity.
constexpr std::uint64_t kSky = std::numeric_limits<std::uint64_t>::max();
inline bool is_sky(const HorizonPiece& piece) {
  return piece.source.id == kSky;
}

/// Pieces that tile X from -infinity to +infinity, in order.
using Horizon = std::vector<HorizonPiece>;

/// The sky alone.
inline Horizon initial_horizon() {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return {{-infinity, infinity, {-infinity, -infinity, infinity, -infinity, kSky}, false}};
}

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
  if (collapse && !pieces.empty() && continues(pieces.back(), piece)) {
    pieces.back().x_end = piece.x_end;
    pieces.back().low = std::min(pieces.back().low, piece.low);
  } else {
    pieces.push_back(piece);
  }
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

/// The horizon's height at x: -infinity where there is sky alone. Of two pieces that meet at x, the
/// left one's. AnyHorizon is what `pieces_from` takes.
template <class AnyHorizon>
double horizon_height(const AnyHorizon& horizon, double x) {
  const auto piece = pieces_from(horizon, x);
  return is_sky(*piece) ? -std::numeric_limits<double>::infinity() : height_at(piece->source, x);
}

} // namespace orograph
