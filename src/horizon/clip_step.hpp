// SPDX-License-Identifier: GPL-3.0-or-later
// One step of the clip: a segment against one piece of the horizon.
//
// Notation: p is the segment that is clipped, s the source of a horizon piece, [a, b] the stretch
// of X looked at: inside p, and inside the piece.
#pragma once

#include "horizon/compare.hpp"
#include "horizon/horizon.hpp"

#include <array>

namespace orograph {

/// A stretch of p above or below s; one step has at most two of them. Its ends along p are reckoned
/// only where they are asked for, since they cost a division each: `t` is the crossing's where a
/// stretch begins or ends at one.
struct Stretch {
  double x_begin, x_end;
  bool above;
  bool begins_at_crossing = false, ends_at_crossing = false;
};

struct Step {
  int count = 1;
  std::array<Stretch, 2> stretches;
  bool tied = false;
  double t = 0; ///< of the crossing
};

/// Parts [a, b] of p by how p stands to a source; a tie is above or not as `tied_above` says.
inline Step step_of(const Standing& standing, double a, double b, bool tied_above) {
  using enum Standing::Kind;
  const auto whole = [&](bool above) { return Step{1, {Stretch{a, b, above}}}; };
  if (standing.kind == tied) {
    Step step = whole(tied_above);
    step.tied = true;
    return step;
  }
  if (standing.kind == above || standing.kind == below) return whole(standing.kind == above);
  const bool first_above = standing.kind == above_then_below;
  // A crossing may round to where a horizon has fragmented: then, too, its place along p is its
  // own.
  if (standing.x <= a)
    return {1, {Stretch{a, b, !first_above, standing.x == a, false}}, false, standing.t};
  if (standing.x >= b)
    return {1, {Stretch{a, b, first_above, false, standing.x == b}}, false, standing.t};
  return {2,
          {Stretch{a, standing.x, first_above, false, true},
           Stretch{standing.x, b, !first_above, true, false}},
          false,
          standing.t};
}

/// What [a, b] of p is against the piece; `exact` knows no ties but those of equal lines. Where p
/// is tied to the piece, `above` is whether to draw p there.
inline Step resolve(const Segment& p, const HorizonPiece& piece, double a, double b, bool exact,
                    const TieTolerance& tolerance) {
  if (is_sky(piece)) return Step{1, {Stretch{a, b, true}}};
  static constexpr TieTolerance kNone{};
  return step_of(compare(p, piece.source, exact ? kNone : tolerance), a, b, !exact && !piece.inked);
}

/// Where a stretch begins and ends along p.
inline double t_begin(const Segment& p, const Step& step, const Stretch& s) {
  return s.begins_at_crossing && s.x_begin != p.x0 ? step.t : parameter_at(p, s.x_begin);
}
inline double t_end(const Segment& p, const Step& step, const Stretch& s) {
  return s.ends_at_crossing && s.x_end != p.x1 ? step.t : parameter_at(p, s.x_end);
}

} // namespace orograph
