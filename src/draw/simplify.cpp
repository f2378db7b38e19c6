// SPDX-License-Identifier: GPL-3.0-or-later
// The directions from the last kept point in which a line passes all points so far within the
// tolerance are a sector between `right` and `left` (counterclockwise from right to left), narrower
// than 180 degrees once a point lies farther away than the tolerance.
#include "draw/simplify.hpp"

#include "geometry/plain_length.hpp"

#include <cmath>

namespace orograph {
namespace {

struct Sector {
  bool open = true; ///< every direction
  Vec2 right, left;

  bool holds(Vec2 d) const { return open || (cross(right, d) >= 0 && cross(d, left) >= 0); }

  // The directions whose line passes the point at d within the tolerance.
  void narrow(Vec2 d, double distance, double tolerance) {
    if (distance <= tolerance) return;
    const double s = tolerance / distance, c = std::sqrt(1 - s * s);
    const Vec2 to_right{c * d.x + s * d.y, c * d.y - s * d.x};
    const Vec2 to_left{c * d.x - s * d.y, c * d.y + s * d.x};
    if (open || cross(right, to_right) > 0) right = to_right;
    if (open || cross(to_left, left) > 0) left = to_left;
    open = false;
  }
};

} // namespace

void simplify(std::span<const Vec2> points, double tolerance, std::vector<std::uint32_t>& kept) {
  kept.clear();
  const auto count = static_cast<std::uint32_t>(points.size());
  if (count == 0) return;
  kept.push_back(0);
  Sector sector;
  double farthest = 0;
  for (std::uint32_t i = 1; i < count; ++i) {
    Vec2 d = points[i] - points[kept.back()];
    double distance = plain_length(d);
    if (!(tolerance > 0) || !sector.holds(d) || distance < farthest) {
      if (kept.back() != i - 1) kept.push_back(i - 1);
      sector = {};
      d = points[i] - points[kept.back()];
      distance = plain_length(d);
    }
    farthest = distance;
    sector.narrow(d, distance, tolerance);
  }
  if (kept.back() != count - 1) kept.push_back(count - 1);
}

} // namespace orograph
