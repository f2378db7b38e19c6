// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/closed_block_judge.hpp"

#include "view/sectors.hpp"

#include <algorithm>
#include <cmath>

namespace orograph {

void ClosedBlockJudge::set_view(const View& view, const TieTolerance& tolerance) {
  view_ = &view;
  tolerance_ = tolerance;
  walk_.set_view(view);
}

ClosedBlockJudge::Sight ClosedBlockJudge::sight(const ProfileLine& line, double t) const {
  const View& view = *view_;
  const auto& [a, b] = line;
  const ProfilePoint at = point_between(a, b, t);
  // Edges that lie between two sectors hide only from so far ahead on.
  const double from_m = std::max(kNearPlanesAhead * view.near_m, view.drawn_from_m);
  if (view.is_perspective() ? at.v <= 1.01 * from_m : !(view.y_per_z > 1e-3)) return Sight::unsure;
  // Level ground that level sight leads along.
  if (!view.is_perspective() && view.y_per_v == 0 && a.z == b.z) return Sight::unsure;
  const Vec2 plane = project(view, at);
  const double sure_m = 1e-5 + 2 * tolerance_.at(plane.x, plane.y) *
                                   (view.is_perspective() ? at.v : 1 / view.y_per_z);
  // A crumb that is shorter than that, beside a vertex.
  if (std::hypot(b.u - a.u, b.v - a.v, b.z - a.z) < sure_m) return Sight::unsure;
  const auto side = [&](ProfilePoint p, double tilt = 0) {
    const double inside_m = walk_.depth_inside_m(p, tilt);
    return inside_m > sure_m          ? Sight::hidden
           : inside_m < 0.01 * sure_m ? Sight::seen
                                      : Sight::unsure;
  };
  const Sight here = side(at);
  if (here == Sight::unsure) return here;
  // What ends just at the point's ray is a matter of rounding: a little to either side, along the
  // line and across the ray, and nearer to the eye, in front of a wall. And the way may lead along
  // the ground, or pass it by less than the tolerance, as what is in a line with another does.
  const double size = std::hypot(b.u - a.u, b.v - a.v);
  const double beside = std::min(1e-4, 1e-5 * std::hypot(at.u, at.v) / std::max(1e-9, size));
  const double aside = 1e-7 * std::hypot(at.u, at.v), nearer = 20 * aside;
  const double along = u_along_ray(view, at), across_size = std::hypot(along, 1);
  const double tilt = std::max(1e-3, sure_m / walk_.cell_m());
  for (const double way : {-1.0, 1.0}) {
    const double across = way * aside;
    const ProfilePoint in_front{at.u + (across - nearer * along) / across_size,
                                at.v - (across * along + nearer) / across_size,
                                at.z - nearer / across_size * z_along_ray(view, at)};
    if (side(at, tilt * way) != here || side(point_between(a, b, t + way * beside)) != here ||
        side(in_front) != here)
      return Sight::unsure;
  }
  return here;
}

} // namespace orograph
