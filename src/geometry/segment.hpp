// SPDX-License-Identifier: GPL-3.0-or-later
// The terrain in the visibility plane: source segments, which are projected straight lines of it,
// and whole profiles.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

namespace orograph {

/// From (x0, y0) to (x1, y1) with x0 < x1, in the coordinates of the visibility plane (per unit of
/// depth in perspective, metres in a parallel view). Pieces of it are told by `id`: two segments
/// with one id are the same segment.
struct Segment {
  double x0, y0, x1, y1;
  std::uint64_t id;
  double slope = (y1 - y0) / (x1 - x0); ///< kept, since a division costs as much as the rest
};

/// Height of the segment's line at x0 <= x <= x1; exactly y0 at x0 and y1 at x1. It is reckoned
/// from the nearer end, so its error is a few ulp of max(|y0|, |y1|) plus slope * ulp(x).
inline double height_at(const Segment& s, double x) {
  const double from_left = x - s.x0, from_right = s.x1 - x;
  return from_left <= from_right ? s.y0 + from_left * s.slope : s.y1 - from_right * s.slope;
}

/// Height of p's line above s's at an x that is within both, zero to the bit where they share an
/// end there. Heights far from zero are taken from each other first, which costs no digits: the
/// error is a few ulp of what the two rise and of their distance.
inline double height_difference(const Segment& p, const Segment& s, double x) {
  const bool p_left = x - p.x0 <= p.x1 - x, s_left = x - s.x0 <= s.x1 - x;
  const double p_rise = (p_left ? x - p.x0 : x - p.x1) * p.slope;
  const double s_rise = (s_left ? x - s.x0 : x - s.x1) * s.slope;
  return ((p_left ? p.y0 : p.y1) - (s_left ? s.y0 : s.y1)) + (p_rise - s_rise);
}

/// Of the visibility plane.
struct XRange {
  double begin, end;
};

/// Vertices `first` to `last` of a profile, with ground between each and the next.
struct VertexRun {
  std::uint32_t first, last;
};

/// All vertices of a profile; X never falls along a run.
struct ProjectedProfile {
  std::vector<double> x, y;
  std::vector<VertexRun> runs;
};

} // namespace orograph
