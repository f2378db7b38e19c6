// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/judge.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace orograph {

Judge::Judge(const Surface& surface, const View& view, const TieTolerance& tolerance)
    : view_(&view), tolerance_(tolerance), walk_(surface, view) {}

void Judge::set_view(const View& view, const TieTolerance& tolerance) {
  view_ = &view;
  tolerance_ = tolerance;
  walk_.set_view(view);
}

Judge::Asked Judge::ask(ProfilePoint at, bool on_edge) const {
  const Vec2 plane = project(*view_, at);
  const InFront front = walk_.in_front(at);
  const double above = plane.y - (on_edge ? front.greatest_y_apart : front.greatest_y);
  const bool is_tied = std::abs(above) <= tolerance_.at(plane.x, plane.y) + front.rounding;
  return {front, above, is_tied ? Verdict::tied : above > 0 ? Verdict::visible : Verdict::hidden};
}

double Judge::above(ProfilePoint at, bool on_edge) const {
  return ask(at, on_edge).above;
}

Verdict Judge::verdict(ProfilePoint at, bool on_edge) const {
  return ask(at, on_edge).verdict;
}

// Where an edge in front ends just at the point's X, rounding of the place decides whether the walk
// meets it; so a point that seems wrong must seem so a rounding farther to either side as well,
// along its line and across the ray (the line may run straight away from the eye, or be shorter).
Verdict Judge::verdict(const ProfileLine& line, double t, bool on_edge, bool drawn) const {
  const Verdict right = drawn ? Verdict::visible : Verdict::hidden;
  const ProfilePoint at = point_between(line.from, line.to, t);
  const bool vertical = line.from.u == line.to.u && line.from.v == line.to.v;
  if (vertical) {
    // A vertical line that is seen from above has no picture.
    const Vec2 place = project(*view_, at);
    const double rise = std::abs(project(*view_, {at.u, at.v, line.to.z}).y -
                                 project(*view_, {at.u, at.v, line.from.z}).y);
    if (rise <= tolerance_.at(place.x, place.y)) return Verdict::tied;
  }
  const Asked asked = ask(at, on_edge);
  const Verdict found = asked.verdict;
  if (found == right || found == Verdict::tied) return found;
  constexpr double kRounding = 64 * std::numeric_limits<double>::epsilon();
  const double length =
      std::hypot(line.to.u - line.from.u, line.to.v - line.from.v, line.to.z - line.from.z);
  const Vec3 ground = to_ground_m(*view_, at);
  const double rounding_m =
      kRounding * (std::abs(ground.x) + std::abs(ground.y) + std::abs(view_->depth_origin_m.x) +
                   std::abs(view_->depth_origin_m.y) + length);
  if (length <= rounding_m) return Verdict::tied;
  // A level line that a level view looks along has no picture, so none of it can be missing.
  if (!view_->is_perspective() || (line.from.v > 0 && line.to.v > 0)) {
    const Vec2 from = project(*view_, line.from), to = project(*view_, line.to);
    const double rounding =
        4 * std::numeric_limits<double>::epsilon() * (std::abs(from.x) + std::abs(from.y));
    if (std::abs(to.x - from.x) <= rounding && std::abs(to.y - from.y) <= rounding)
      return Verdict::tied;
  }
  // Across the ray as far as it takes for it to miss what stands nearer to the eye.
  const InFront& front = asked.front;
  const bool perspective = view_->is_perspective();
  const double farther = perspective && front.at_depth_m > 0 ? at.v / front.at_depth_m : 1;
  const double by_m = farther * std::max(rounding_m, 16 * front.rounding_m);
  const double away_m = std::hypot(at.u, at.v);
  const auto is_same = [&](double way_m, double nearer_m) {
    ProfilePoint aside{at.u + way_m, at.v - nearer_m, at.z};
    if (perspective)
      aside = {at.u + (way_m * at.v - nearer_m * at.u) / away_m,
               at.v - (way_m * at.u + nearer_m * at.v) / away_m, at.z};
    // Where its own ground rises aside, a place as high is under that by a rounding.
    const Asked there = ask(aside, on_edge);
    return there.verdict == found &&
           (found == Verdict::visible || there.above <= 0.5 * asked.above);
  };
  for (const double way_m : {-by_m, by_m}) {
    const double along = std::clamp(t + way_m / length, 0.0, 1.0);
    if (verdict(point_between(line.from, line.to, along), on_edge) != found) return Verdict::tied;
    // On a wall towards the eye as well: to the side alone may be behind it.
    if (!is_same(way_m, vertical ? 64 * by_m : 0)) return Verdict::tied;
  }
  if (vertical && !is_same(-by_m, 0) && !is_same(by_m, 0)) return Verdict::tied;
  return found;
}

} // namespace orograph
