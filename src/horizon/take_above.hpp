// SPDX-License-Identifier: GPL-3.0-or-later
// What of a drawn line is above a piece of the horizon.
#pragma once

#include "horizon/compare.hpp"
#include "horizon/horizon.hpp"

#include <algorithm>

namespace orograph {

/// Calls take(begin, end) with what of p, which stands so to the piece's source, is above the piece
/// between two abscissae that are within both, as shares of p's way from left to right; of a tie
/// all, if no line is drawn there already.
template <class Take>
void take_above(const Standing& standing, const Segment& p, const HorizonPiece& piece,
                double x_begin, double x_end, const Take& take) {
  using enum Standing::Kind;
  if (standing.kind == below || (standing.kind == tied && piece.inked)) return;
  const double begin = parameter_at(p, x_begin), end = parameter_at(p, x_end);
  const double t = std::clamp(standing.t, begin, end);
  if (standing.kind == above || standing.kind == tied) take(begin, end);
  if (standing.kind == above_then_below) take(begin, t);
  if (standing.kind == below_then_above) take(t, end);
}

/// As that with a piece's source; p is above the sky.
inline Standing compare(const Segment& p, const HorizonPiece& piece,
                        const TieTolerance& tolerance) {
  return is_sky(piece) ? Standing{Standing::Kind::above} : compare(p, piece.source, tolerance);
}

} // namespace orograph
