// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/sight_segment.hpp"

#include <algorithm>

namespace orograph {
namespace {

LongVec normal_of(const LongTriangle& t) {
  return cross(t[1] - t[0], t[2] - t[0]);
}

SightSegment edge_of(const LongTriangle& t, std::size_t k) {
  return {t[k], t[(k + 1) % 3]};
}

// Six times the volume between the segment and an edge of the triangle: its sign says on which side
// of the edge the line passes.
long double volume(const SightSegment& segment, const SightSegment& edge) {
  return dot(cross(segment.to - segment.from, edge.to - edge.from), edge.from - segment.from);
}

// Of two segments. The least of a quadratic form over the unit square is inside of it, or on its
// border, where one of the four ends takes part.
long double distance_m(const SightSegment& a, const SightSegment& b) {
  const long double at_ends =
      std::min({orograph::distance_m(a.from, b), orograph::distance_m(a.to, b),
                orograph::distance_m(b.from, a), orograph::distance_m(b.to, a)});
  const LongVec along_a = a.to - a.from, along_b = b.to - b.from, between = b.from - a.from;
  const LongVec across = cross(along_a, along_b);
  const long double size = dot(across, across);
  if (!(size > 0)) return at_ends;
  const long double s = dot(cross(between, along_b), across) / size,
                    t = dot(cross(between, along_a), across) / size;
  if (!(s > 0 && s < 1 && t > 0 && t < 1)) return at_ends;
  return std::min(at_ends, std::abs(dot(between, across)) / std::sqrt(size));
}

} // namespace

long double distance_m(LongVec point, const SightSegment& segment) {
  const LongVec along = segment.to - segment.from;
  const long double size = dot(along, along);
  const long double share =
      size > 0 ? std::clamp(dot(point - segment.from, along) / size, 0.0L, 1.0L) : 0;
  return length(point - (segment.from + share * along));
}

long double distance_m(LongVec point, const LongTriangle& triangle) {
  const LongVec normal = normal_of(triangle);
  const long double size = length(normal);
  bool above = size > 0;
  long double least = distance_m(point, edge_of(triangle, 0));
  for (std::size_t k = 0; k < 3; ++k) {
    const SightSegment edge = edge_of(triangle, k);
    least = std::min(least, distance_m(point, edge));
    above = above && dot(cross(normal, edge.to - edge.from), point - edge.from) >= 0;
  }
  return above ? std::abs(dot(normal, point - triangle[0])) / size : least;
}

bool crosses(const SightSegment& segment, const LongTriangle& triangle) {
  const LongVec normal = normal_of(triangle);
  const long double begin = dot(normal, segment.from - triangle[0]),
                    end = dot(normal, segment.to - triangle[0]);
  if (begin == end || begin * end > 0) return false;
  int left = 0, right = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const long double side = volume(segment, edge_of(triangle, k));
    left += side >= 0;
    right += side <= 0;
  }
  return left == 3 || right == 3;
}

bool surely_crosses(const SightSegment& segment, const LongTriangle& triangle, long double by_m) {
  if (!crosses(segment, triangle)) return false;
  const LongVec normal = normal_of(triangle);
  const long double least = by_m * length(normal);
  if (std::abs(dot(normal, segment.from - triangle[0])) <= least ||
      std::abs(dot(normal, segment.to - triangle[0])) <= least)
    return false;
  for (std::size_t k = 0; k < 3; ++k) {
    const SightSegment edge = edge_of(triangle, k);
    const LongVec across = cross(segment.to - segment.from, edge.to - edge.from);
    if (std::abs(volume(segment, edge)) <= by_m * length(across)) return false;
  }
  return true;
}

long double distance_m(const SightSegment& segment, const LongTriangle& triangle) {
  if (crosses(segment, triangle)) return 0;
  long double least =
      std::min(distance_m(segment.from, triangle), distance_m(segment.to, triangle));
  for (std::size_t k = 0; k < 3; ++k)
    least = std::min(least, distance_m(segment, edge_of(triangle, k)));
  return least;
}

} // namespace orograph
