// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/sheet_walk.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace orograph {
namespace {

// What the way to the eye has above it of a triangle: from one place along it to another, by how
// much the triangle is higher there.
struct Passed {
  double begin, end, above_begin, above_end;
};

} // namespace

bool SheetWalk::is_on_wall_edge_on(ProfilePoint point) const {
  const double along = u_along_ray(*view_, point), rounding_m = 1e-9 * std::hypot(point.u, point.v);
  return std::ranges::any_of(ways_.tin().triangles, [&](const auto& corners) {
    double across_low = 0, across_high = 0, away_low = 0,
           away_high = 0; // of the ray, seen from above
    for (const std::uint32_t corner : corners) {
      const ProfilePoint p = to_profile_frame(*view_, ways_.tin().vertices_m[corner]);
      const double across = (p.u - point.u - along * (p.v - point.v)) / std::hypot(along, 1);
      across_low = std::min(across_low, across);
      across_high = std::max(across_high, across);
      away_low = std::min(away_low, p.v - point.v);
      away_high = std::max(away_high, p.v - point.v);
    }
    return across_high - across_low <= 2 * (kAtPoint_m + rounding_m) &&
           away_high - away_low > kAtPoint_m;
  });
}

SheetWalk::Sight SheetWalk::sight(ProfilePoint point, double tolerance_m) const {
  const StraightWay way = StraightWay::to_eye(*view_, point);
  const double at_point = kAtPoint_m / std::hypot(way.step.u, way.step.v);
  std::vector<Passed> passed;
  bool is_unsure = false;
  ways_.for_each(*view_, way, 4 * kAtPoint_m, [&](const TrianglePassage& of) {
    const auto above = [&](double s) { return of.height_m(s) - way.z_m(s); };
    if (of.low + at_point < of.high) // not only touched
      passed.push_back({of.low, of.high, above(of.low), above(of.high)});
    else if (std::abs(above(of.high) - above(of.low)) > tolerance_m)
      is_unsure = true; // a wall that is as good as upright
  });
  std::sort(passed.begin(), passed.end(),
            [](const Passed& a, const Passed& b) { return a.begin < b.begin; });
  const auto sign = [&](double above) {
    return above > tolerance_m ? 1 : above < -tolerance_m ? -1 : 0;
  };
  Sight seen = Sight::edge;
  for (std::size_t first = 0, end = 0; first < passed.size(); first = end) {
    // As far as the ground goes on.
    for (end = first + 1;
         end < passed.size() && passed[end].begin <= passed[end - 1].end + at_point;)
      ++end;
    const bool is_own = passed[first].begin <= at_point;
    bool is_above = false, is_below = false, is_near = false, leaves_point = false;
    double least = 0, most = 0; // until it has left the point
    for (std::size_t i = first; i < end; ++i)
      for (const bool at_begin : {true, false}) {
        const double above = at_begin ? passed[i].above_begin : passed[i].above_end;
        const int side = sign(above);
        // From the point itself it leads away, unless it is level with it still at the next edge.
        if (side == 0 && !(is_own && i == first && at_begin)) is_near = true;
        if (side == 0 && !leaves_point) {
          least = std::min(least, above);
          most = std::max(most, above);
        }
        if (side != 0) leaves_point = true;
        is_above = is_above || side > 0;
        is_below = is_below || side < 0;
      }
    if (is_above && is_below) return Sight::hidden;
    if (is_near || (is_own && !leaves_point)) is_unsure = true;
    if (!is_own) continue;
    // A wrinkle right at the point that leads to the other side.
    const double wrinkle = is_below ? most : -least;
    if (wrinkle > 1e-3 * tolerance_m) is_unsure = true;
    seen = is_below ? Sight::upper : Sight::underside;
  }
  return is_unsure ? Sight::unsure : seen;
}

} // namespace orograph
