// SPDX-License-Identifier: GPL-3.0-or-later
// A straight line of sight against one triangle.
#pragma once

#include "reference/long_vec.hpp"

#include <array>

namespace orograph {

using LongTriangle = std::array<LongVec, 3>;

/// From the eye to the point that it looks at.
struct SightSegment {
  LongVec from, to;
};

/// Whether the two have a point in common, as signed volumes have it; a triangle's edges and
/// corners belong to it. A segment in the triangle's plane doesn't cross it.
bool crosses(const SightSegment& segment, const LongTriangle& triangle);

/// Whether they have even where both ends of the segment and the triangle's corners are moved by up
/// to `by_m` / 2: the line passes the edges by more than by_m, and the ends are farther than that
/// from the plane.
bool surely_crosses(const SightSegment& segment, const LongTriangle& triangle, long double by_m);

/// 0 where they cross.
long double distance_m(const SightSegment& segment, const LongTriangle& triangle);
long double distance_m(LongVec point, const LongTriangle& triangle);
long double distance_m(LongVec point, const SightSegment& segment);

} // namespace orograph
