// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/ways_over_tin.hpp"

#include "dem/approximate/tin_of_grid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace orograph {
namespace {

// Whether a triangle is upright, to the rounding of its corners' differences: where it has been
// turned into a view's frame it may seem to have an area that is nothing but rounding.
bool is_upright(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double ab_ac = (b.x - a.x) * (c.y - a.y), ac_ab = (b.y - a.y) * (c.x - a.x);
  return std::abs(ab_ac - ac_ab) <=
         4 * std::numeric_limits<double>::epsilon() * (std::abs(ab_ac) + std::abs(ac_ab));
}

} // namespace

StraightWay StraightWay::to_eye(const View& view, ProfilePoint point) {
  const Spatial from = of(point);
  if (view.is_perspective())
    return {from, Spatial{0, 0, view.eye_z_m} - from, 1 - view.near_m / point.v};
  return {from,
          {view.x_per_v, -1, view.y_per_v / view.y_per_z},
          std::numeric_limits<double>::infinity()};
}

WaysOverTin::WaysOverTin(const Surface& surface)
    : own_(std::holds_alternative<Grid>(surface)
               ? std::make_shared<const Tin>(tin_of(std::get<Grid>(surface)))
               : nullptr),
      tin_(own_ ? own_.get() : &std::get<Tin>(surface)),
      index_(std::make_shared<const TinIndex>(*tin_)) {
  for (const Vec3& vertex : tin_->vertices_m)
    reach_m_ = std::max(reach_m_, std::hypot(vertex.x, vertex.y));
}

void WaysOverTin::for_each(const View& view, const StraightWay& way, double beside_m,
                           const std::function<void(const TrianglePassage&)>& take) const {
  const auto& [from, step, end] = way;
  const auto ground = [&](double s) {
    return view.depth_origin_m + (from.u + s * step.u) * view.right +
           (from.v + s * step.v) * view.forward;
  };
  // As far as there is terrain.
  const Vec2 at = ground(0);
  const double far =
      view.is_perspective() ? end : (length(at) + reach_m_) / std::hypot(step.u, step.v);
  index_->along(at, ground(far), beside_m, near_);
  for (const std::uint32_t t : near_) {
    std::array<Vec3, 3> places_m{};
    std::array<Spatial, 3> corners{};
    for (std::size_t k = 0; k < 3; ++k) {
      places_m[k] = tin_->vertices_m[tin_->triangles[t][k]];
      corners[k] = of(to_profile_frame(view, places_m[k]));
    }
    const Spatial a = corners[0], ab = corners[1] - a, ac = corners[2] - a;
    const double area = plan_cross(ab, ac);
    if (area == 0 || is_upright(places_m[0], places_m[1], places_m[2])) continue;
    double low = 0, high = end;
    const auto keep = [&](double at_0, double per_s) { // where it isn't negative
      if (per_s > 0)
        low = std::max(low, -at_0 / per_s);
      else if (per_s < 0)
        high = std::min(high, -at_0 / per_s);
      else if (at_0 < 0)
        high = -std::numeric_limits<double>::infinity();
    };
    const Spatial from_a = from - a;
    const double b_0 = plan_cross(from_a, ac) / area, b_s = plan_cross(step, ac) / area,
                 c_0 = plan_cross(ab, from_a) / area, c_s = plan_cross(ab, step) / area;
    keep(b_0, b_s);
    keep(c_0, c_s);
    keep(1 - b_0 - c_0, -b_s - c_s);
    if (low < high) take({t, low, high, a.z, ab.z, ac.z, b_0, b_s, c_0, c_s});
  }
}

} // namespace orograph
