// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/closed_block_walk.hpp"

#include "dem/approximate/tin_of_grid.hpp"
#include "reference/spatial.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace orograph {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

} // namespace

ClosedBlockWalk::ClosedBlockWalk(const TerrainData& terrain, double base_m, const View& view)
    : own_(std::holds_alternative<Grid>(terrain.surface)
               ? std::make_shared<const Tin>(tin_of(std::get<Grid>(terrain.surface)))
               : nullptr),
      tin_(own_ ? own_.get() : &std::get<Tin>(terrain.surface)), view_(&view),
      index_(std::make_shared<const TinIndex>(*tin_)) {
  const MapFrame& map = terrain.map;
  for (const Vec3& vertex : tin_->vertices_m) {
    reach_m_ = std::max(reach_m_, std::hypot(vertex.x, vertex.y));
    // On the ellipsoid straight below is so in the frame.
    const double depth_m =
        map.earth ? map.earth->exaggeration * (map.to_map(vertex).z * map.height_unit_m - base_m)
                  : vertex.z - base_m;
    base_z_m_.push_back(vertex.z - depth_m);
  }
  double area_m2 = 0;
  for (const auto& [a, b, c] : tin_->triangles) {
    const Vec3 from = tin_->vertices_m[a], ab = tin_->vertices_m[b] - from,
               ac = tin_->vertices_m[c] - from;
    area_m2 += std::abs(ab.x * ac.y - ab.y * ac.x); // twice
  }
  cell_m_ = std::sqrt(area_m2 / static_cast<double>(tin_->triangles.size()));
}

double ClosedBlockWalk::depth_inside_m(ProfilePoint point, double tilt) const {
  const View& view = *view_;
  const Spatial from = of(point);
  Spatial step = view.is_perspective() ? Spatial{0, 0, view.eye_z_m} - from
                                       : Spatial{view.x_per_v, -1, view.y_per_v / view.y_per_z};
  const double length_a_step = std::hypot(step.u, step.v);
  step.z += tilt * length_a_step;
  const double end = view.is_perspective() ? 1 - view.near_m / point.v : kInfinity;
  const auto ground = [&](double u, double v) {
    return view.depth_origin_m + u * view.right + v * view.forward;
  };
  // Towards the eye as far as there is terrain.
  constexpr double kBeside_m = 1e-5;
  const Vec2 at = ground(point.u, point.v);
  const double far = view.is_perspective() ? end : (length(at) + reach_m_) / length_a_step;
  index_->along(at, ground(point.u + far * step.u, point.v + far * step.v), kBeside_m, near_);
  double deepest_m = -kInfinity;
  for (const std::uint32_t t : near_) {
    std::array<Spatial, 3> tops{};
    std::array<double, 3> base_z{};
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t vertex = tin_->triangles[t][k];
      Vec3 place = tin_->vertices_m[vertex];
      tops[k] = of(to_profile_frame(view, place));
      place.z = base_z_m_[vertex];
      base_z[k] = to_profile_frame(view, place).z;
    }
    const Spatial a = tops[0], ab = tops[1] - a, ac = tops[2] - a;
    const double area = plan_cross(ab, ac);
    if (area == 0) continue;
    double low = 0, high = end;
    const auto keep = [&](double at_0, double per_s) { // where it isn't negative
      if (per_s > 0)
        low = std::max(low, -at_0 / per_s);
      else if (per_s < 0)
        high = std::min(high, -at_0 / per_s);
      else if (at_0 < 0)
        high = -kInfinity;
    };
    const Spatial from_a = from - a;
    const double b_0 = plan_cross(from_a, ac) / area, b_s = plan_cross(step, ac) / area,
                 c_0 = plan_cross(ab, from_a) / area, c_s = plan_cross(ab, step) / area;
    keep(b_0, b_s);
    keep(c_0, c_s);
    keep(1 - b_0 - c_0, -b_s - c_s);
    if (!(low < high)) continue;
    const auto inside = [&](double s) {
      const double b = b_0 + s * b_s, c = c_0 + s * c_s, z = from.z + s * step.z;
      const double surface = a.z + b * ab.z + c * ac.z,
                   base = base_z[0] + b * (base_z[1] - base_z[0]) + c * (base_z[2] - base_z[0]);
      return std::array{surface - z, z - base};
    };
    // The lesser of two that are linear: greatest at an end, or where they are equal.
    const auto [top_low, base_low] = inside(low);
    const auto [top_high, base_high] = inside(high);
    deepest_m = std::max({deepest_m, std::min(top_low, base_low), std::min(top_high, base_high)});
    const double gap_low = top_low - base_low, gap_high = top_high - base_high;
    if ((gap_low < 0) != (gap_high < 0)) {
      const auto [top, base] = inside(low + gap_low / (gap_low - gap_high) * (high - low));
      deepest_m = std::max(deepest_m, std::min(top, base));
    }
  }
  return deepest_m;
}

} // namespace orograph
