// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/sheet_walk.hpp"

#include "dem/approximate/tin_of_grid.hpp"
#include "reference/spatial.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace orograph {
namespace {

// What the way to the eye has above it of a triangle: from one place along it to another, by how
// much the triangle is higher there.
struct Passed {
  double begin, end, above_begin, above_end;
};

} // namespace

SheetWalk::SheetWalk(const Surface& surface, const View& view)
    : own_(std::holds_alternative<Grid>(surface)
               ? std::make_shared<const Tin>(tin_of(std::get<Grid>(surface)))
               : nullptr),
      tin_(own_ ? own_.get() : &std::get<Tin>(surface)), view_(&view),
      index_(std::make_shared<const TinIndex>(*tin_)) {
  for (const Vec3& vertex : tin_->vertices_m)
    reach_m_ = std::max(reach_m_, std::hypot(vertex.x, vertex.y));
}

SheetWalk::Sight SheetWalk::sight(ProfilePoint point, double tolerance_m) const {
  const View& view = *view_;
  const Spatial from = of(point);
  const Spatial step = view.is_perspective()
                           ? Spatial{0, 0, view.eye_z_m} - from
                           : Spatial{view.x_per_v, -1, view.y_per_v / view.y_per_z};
  const double last =
      view.is_perspective() ? 1 - view.near_m / point.v : std::numeric_limits<double>::infinity();
  // What is this close to the point, seen from above, is at it.
  constexpr double kAtPoint_m = 1e-6;
  const double at_point = kAtPoint_m / std::hypot(step.u, step.v);
  const auto ground = [&](double u, double v) {
    return view.depth_origin_m + u * view.right + v * view.forward;
  };
  const Vec2 at = ground(point.u, point.v);
  // Towards the eye as far as there is terrain.
  const double far =
      view.is_perspective() ? last : (length(at) + reach_m_) / std::hypot(step.u, step.v);
  index_->along(at, ground(point.u + far * step.u, point.v + far * step.v), 4 * kAtPoint_m, near_);
  std::vector<Passed> passed;
  for (const std::uint32_t t : near_) {
    std::array<Spatial, 3> corners{};
    for (std::size_t k = 0; k < 3; ++k)
      corners[k] = of(to_profile_frame(view, tin_->vertices_m[tin_->triangles[t][k]]));
    const Spatial a = corners[0], ab = corners[1] - a, ac = corners[2] - a;
    const double area = plan_cross(ab, ac);
    if (area == 0) continue;
    double low = 0, high = last;
    const auto keep = [&](double at_0, double per_s) { // where it isn't negative
      if (per_s > 0)
        low = std::max(low, -at_0 / per_s);
      else if (per_s < 0)
        high = std::min(high, -at_0 / per_s);
      else if (at_0 < 0)
        high = -1;
    };
    const Spatial from_a = from - a;
    const double b_0 = plan_cross(from_a, ac) / area, b_s = plan_cross(step, ac) / area,
                 c_0 = plan_cross(ab, from_a) / area, c_s = plan_cross(ab, step) / area;
    keep(b_0, b_s);
    keep(c_0, c_s);
    keep(1 - b_0 - c_0, -b_s - c_s);
    if (!(low + at_point < high)) continue; // only touched
    const auto above = [&](double s) {
      return a.z + (b_0 + s * b_s) * ab.z + (c_0 + s * c_s) * ac.z - (from.z + s * step.z);
    };
    passed.push_back({low, high, above(low), above(high)});
  }
  std::sort(passed.begin(), passed.end(),
            [](const Passed& a, const Passed& b) { return a.begin < b.begin; });
  const auto sign = [&](double above) {
    return above > tolerance_m ? 1 : above < -tolerance_m ? -1 : 0;
  };
  Sight seen = Sight::edge;
  bool is_unsure = false;
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
