// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/sheet_judge.hpp"

#include <algorithm>
#include <cmath>

namespace orograph {

void SheetJudge::set_view(const View& view, const TieTolerance& tolerance) {
  view_ = &view;
  tolerance_ = tolerance;
  walk_.set_view(view);
}

SheetJudge::Answer SheetJudge::ask(const ProfileLine& line, double t, const Drawn& drawn) const {
  using Sight = SheetWalk::Sight;
  const auto& [a, b] = line;
  const double size = std::hypot(b.u - a.u, b.v - a.v, b.z - a.z);
  constexpr double kCrumb_m = 1e-6; // at a vertex
  const bool is_plan = !view_->is_perspective() && !(view_->y_per_z > 1e-3);
  if (is_plan || size < kCrumb_m) return {Verdict::unsure, Sight::unsure};
  const ProfilePoint at = point_between(a, b, t);
  const Vec2 plane = project(*view_, at);
  const double tolerance_m = 1e-5 + 2 * tolerance_.at(plane.x, plane.y) *
                                        (view_->is_perspective() ? at.v : 1 / view_->y_per_z);
  const bool is_upright = std::hypot(b.u - a.u, b.v - a.v) < kCrumb_m;
  if (is_upright && (size < tolerance_m || walk_.is_on_wall_edge_on(at)))
    return {Verdict::unsure, Sight::unsure};
  const Sight sight = walk_.sight(at, tolerance_m);
  // What ends just at the point's ray is a matter of rounding: a little to both sides, of short
  // lines too beyond what the walk takes for the point itself.
  const double beside = std::max(std::min(1e-4, 1e-5 * std::hypot(at.u, at.v) / size),
                                 100 * SheetWalk::kAtPoint_m / size);
  const auto is_same = [&](double at_t) {
    return walk_.sight(point_between(a, b, at_t), tolerance_m) == sight;
  };
  if (sight == Sight::unsure || !is_same(t - beside) || !is_same(t + beside))
    return {Verdict::unsure, sight};
  // A line straight away from the eye may be seen from one side alone, beside a wall above it; and
  // so may one up a wall, at its corner, or where the wall is seen edge-on.
  const double along = u_along_ray(*view_, at),
               aside_m = std::max(1e-6, 1e-8 * std::hypot(at.u, at.v));
  if (is_upright || std::abs(b.u - a.u - along * (b.v - a.v)) <= 1e-9 * size) {
    const double nearer_m = is_upright ? 20 * aside_m : 0; // in front of the wall
    for (const double way : {-aside_m, aside_m})
      if (walk_.sight({at.u + way - nearer_m * along, at.v - way * along - nearer_m,
                       at.z - nearer_m * z_along_ray(*view_, at)},
                      tolerance_m) != sight)
        return {Verdict::unsure, sight};
  }
  const bool may_be_upper = sight == Sight::upper || sight == Sight::edge,
             may_be_underside = sight == Sight::underside || sight == Sight::edge;
  const auto& [is_on_upper_alone, as_upper, as_underside] = drawn;
  bool is_wrong = false, is_missing = false;
  if (is_on_upper_alone) {
    is_wrong = as_upper && !may_be_upper;
    is_missing = sight == Sight::upper && !as_upper;
  } else if (as_upper && as_underside) {
    is_wrong = sight == Sight::hidden;
  } else {
    is_wrong = (as_upper && !may_be_upper) || (as_underside && !may_be_underside);
    is_missing = sight != Sight::hidden && !as_upper && !as_underside;
  }
  const Verdict verdict = is_wrong     ? Verdict::drawn_wrong
                          : is_missing ? Verdict::missing
                                       : Verdict::right;
  return {verdict, sight};
}

} // namespace orograph
