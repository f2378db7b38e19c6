// SPDX-License-Identifier: GPL-3.0-or-later
// What of a drawn line is above a piece of the horizon.
#pragma once

#include "horizon/compare.hpp"
#include "horizon/horizon.hpp"

#include <algorithm>

namespace orograph {

/// Calls take(begin, end) with what of p, between two abscissae that are within both, is above the
/// piece, as shares of p's way from left to right; of a tie with it all, if no line is drawn there
/// already. Tells how p stands to the piece.
template <class Take>
Standing take_above(const Segment& p, const HorizonPiece& piece, double x_begin, double x_end,
                    const TieTolerance& tolerance, const Take& take) {
  using enum Standing::Kind;
  const Standing standing = is_sky(piece) ? Standing{above} : compare(p, piece.source, tolerance);
  if (standing.kind == below || (standing.kind == tied && piece.inked)) return standing;
  const double begin = parameter_at(p, x_begin), end = parameter_at(p, x_end);
  const double t = std::clamp(standing.t, begin, end);
  if (standing.kind == above || standing.kind == tied) take(begin, end);
  if (standing.kind == above_then_below) take(begin, t);
  if (standing.kind == below_then_above) take(t, end);
  return standing;
}

} // namespace orograph
