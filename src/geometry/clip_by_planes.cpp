// SPDX-License-Identifier: GPL-3.0-or-later
// Where a plane's values a and b at an edge's ends differ in sign, the edge crosses the plane at
// t = a / (a - b).
#include "geometry/clip_by_planes.hpp"

#include <bit>

namespace orograph {
namespace {

// The shares t of an edge that are inside a plane: first <= t <= last.
struct Inside {
  double first, last;
};
using EdgeInside = std::array<Inside, kVolumePlanes>;

Inside inside(double from, double to) {
  if (from < 0 && to < 0) return {2, -1}; // none
  if (from < 0) return {from / (from - to), 1};
  if (to < 0) return {0, from / (from - to)};
  return {0, 1};
}

// Bit i is set where the edge's point at t is outside plane i. Told by t and not by the point, so
// that what was moved to a plane is no longer outside it.
unsigned outcode(const EdgeInside& edge, double t) {
  unsigned code = 0;
  for (unsigned plane = 0; plane < kVolumePlanes; ++plane)
    if (t < edge[plane].first || t > edge[plane].last) code |= 1U << plane;
  return code;
}

} // namespace

std::optional<SharesInside> clip_by_planes(const PlaneValues& from, const PlaneValues& to) {
  EdgeInside edge;
  for (unsigned plane = 0; plane < kVolumePlanes; ++plane)
    edge[plane] = inside(from[plane], to[plane]);

  SharesInside shares;
  unsigned begin_code = outcode(edge, shares.begin), end_code = outcode(edge, shares.end);
  // An end that is outside a plane which the other end is not outside of has a crossing with it
  // further in, so each move clears a bit for good.
  while ((begin_code & end_code) == 0) {
    if (begin_code != 0) {
      shares.begin = edge[std::countr_zero(begin_code)].first;
      begin_code = outcode(edge, shares.begin);
    } else if (end_code != 0) {
      shares.end = edge[std::countr_zero(end_code)].last;
      end_code = outcode(edge, shares.end);
    } else {
      return shares;
    }
  }
  return std::nullopt;
}

} // namespace orograph
