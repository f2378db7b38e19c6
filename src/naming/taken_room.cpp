// SPDX-License-Identifier: GPL-3.0-or-later
#include "naming/taken_room.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace orograph {
namespace {

// Places are whole steps of the page, of which these are far less.
constexpr double kTouching_mm = 1e-6;

bool overlap(const Box2& a, const Box2& b) {
  return a.low.x < b.high.x - kTouching_mm && b.low.x < a.high.x - kTouching_mm &&
         a.low.y < b.high.y - kTouching_mm && b.low.y < a.high.y - kTouching_mm;
}

struct Reach {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
};
Reach along(const TurnedBox& box, Vec2 axis) {
  Reach out;
  for (const Vec2 corner : box) {
    const double at = dot(corner, axis);
    out = {std::min(out.low, at), std::max(out.high, at)};
  }
  return out;
}

// Whether one of a box's sides stands between the two.
bool parts(const TurnedBox& of, const TurnedBox& a, const TurnedBox& b) {
  for (std::size_t i = 0; i < 2; ++i) {
    const Vec2 side = of[i + 1] - of[i];
    const double size = length(side);
    if (!(size > 0)) continue;
    const Vec2 axis = 1 / size * side;
    const Reach one = along(a, axis), other = along(b, axis);
    if (one.high - kTouching_mm <= other.low || other.high - kTouching_mm <= one.low) return true;
  }
  return false;
}

TurnedBox grown(const TurnedBox& box, Vec2 along, Vec2 down, double by_mm) {
  return {box[0] - by_mm * along - by_mm * down, box[1] + by_mm * along - by_mm * down,
          box[2] + by_mm * along + by_mm * down, box[3] - by_mm * along + by_mm * down};
}

} // namespace

TurnedBox box_of(const PageText& text, double margin_mm) {
  const Vec2 along{cos(text.angle), -sin(text.angle)};
  return grown(text.corners_mm(), along, {-along.y, along.x}, margin_mm);
}

TurnedBox box_of(Vec2 from_mm, Vec2 to_mm, double margin_mm) {
  const double size = length(to_mm - from_mm);
  const Vec2 along = size > 0 ? 1 / size * (to_mm - from_mm) : Vec2{1, 0};
  return grown({from_mm, to_mm, to_mm, from_mm}, along, {-along.y, along.x}, margin_mm);
}

Box2 bounds_of(const TurnedBox& box) {
  Box2 out;
  for (const Vec2 corner : box) out.include(corner);
  return out;
}

bool is_inside(const Box2& box, const Box2& room) {
  return box.low.x >= room.low.x && box.high.x <= room.high.x && box.low.y >= room.low.y &&
         box.high.y <= room.high.y;
}

bool overlap(const TurnedBox& a, const TurnedBox& b) {
  return overlap(bounds_of(a), bounds_of(b)) && !parts(a, a, b) && !parts(b, a, b);
}

bool TakenRoom::is_free(const TurnedBox& box) const {
  const Box2 bounds = bounds_of(box);
  return std::ranges::none_of(boxes_, [&](const Taken& taken) {
    return overlap(taken.bounds, bounds) && overlap(taken.box, box);
  });
}

void TakenRoom::take(const TurnedBox& box) {
  boxes_.push_back({box, bounds_of(box)});
}

} // namespace orograph
