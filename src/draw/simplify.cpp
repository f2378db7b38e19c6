// SPDX-License-Identifier: GPL-3.0-or-later
// The directions from the last kept point in which a line passes all points so far within the
// tolerance are a sector between `right` and `left` (counterclockwise from right to left), narrower
// than 180 degrees once a point lies farther away than the tolerance, and than 90 degrees once one
// lies sqrt(2) times as far. A point of so narrow a sector moves a side only if it is farther from
// it than the tolerance; roots are taken only then. The sides are as long as the square of the
// distance of the point that they pass.
#include "draw/simplify.hpp"

#include "geometry/on_all_cores.hpp"

#include <cmath>
#include <numeric>

namespace orograph {
namespace {

struct Side {
  Vec2 direction;
  double free; ///< how far off it points may be without moving it, times its length
};

struct Sides {
  Side right, left;
};

// Between them are the directions whose line passes the point at d within the tolerance. REQUIRES
// that it is farther away.
Sides beside(Vec2 d, double squared, double tolerance) {
  const Vec2 along = std::sqrt(squared - tolerance * tolerance) * d, across = tolerance * d;
  const double free = tolerance * squared;
  return {{{along.x + across.y, along.y - across.x}, free},
          {{along.x - across.y, along.y + across.x}, free}};
}

// The last point that a line from the point `from` reaches. REQUIRES that there is one behind it.
std::size_t reach_from(std::span<const Vec2> points, std::size_t from, double tolerance) {
  const Vec2 start = points[from];
  double farthest = 0; // squared
  std::size_t i = from + 1;
  for (;; ++i) { // as long as every direction will do
    if (i == points.size()) return i - 1;
    const Vec2 d = points[i] - start;
    const double squared = dot(d, d);
    if (squared < farthest) return i - 1;
    farthest = squared;
    if (!(squared <= tolerance * tolerance)) break;
  }
  auto [right, left] = beside(points[i] - start, farthest, tolerance);
  // Tells whether the line reaches the next point, and narrows the sector.
  const auto reaches = [&](const auto& narrow) {
    const Vec2 d = points[i] - start;
    const double squared = dot(d, d);
    const double off_right = cross(right.direction, d), off_left = cross(d, left.direction);
    if (squared < farthest || !(off_right >= 0 && off_left >= 0)) return false;
    farthest = squared;
    narrow(d, off_right, off_left);
    return true;
  };
  const auto narrow_wide = [&](Vec2 d, double, double) {
    const Sides sides = beside(d, farthest, tolerance);
    if (cross(right.direction, sides.right.direction) > 0) right = sides.right;
    if (cross(sides.left.direction, left.direction) > 0) left = sides.left;
  };
  const auto narrow = [&](Vec2 d, double off_right, double off_left) {
    if (off_right > right.free || off_left > left.free) {
      const Sides sides = beside(d, farthest, tolerance);
      if (off_right > right.free) right = sides.right;
      if (off_left > left.free) left = sides.left;
    }
  };
  for (++i; i < points.size() && farthest < 2 * tolerance * tolerance; ++i)
    if (!reaches(narrow_wide)) return i - 1;
  for (; i < points.size(); ++i)
    if (!reaches(narrow)) return i - 1;
  return i - 1;
}

} // namespace

void simplify(std::span<const Vec2> points, double tolerance, std::vector<std::uint32_t>& kept) {
  kept.clear();
  if (!(tolerance > 0)) {
    kept.resize(points.size());
    std::iota(kept.begin(), kept.end(), 0U);
    return;
  }
  for (std::size_t at = 0; at < points.size(); at = reach_from(points, at, tolerance)) {
    throw_if_stopped(kept.size() + 1);
    kept.push_back(static_cast<std::uint32_t>(at));
    if (at + 1 == points.size()) break;
  }
}

} // namespace orograph
