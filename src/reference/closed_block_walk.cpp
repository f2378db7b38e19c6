// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/closed_block_walk.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace orograph {

ClosedBlockWalk::ClosedBlockWalk(const TerrainData& terrain, double base_m, const View& view)
    : ways_(terrain.surface), view_(&view) {
  const Tin& tin = ways_.tin();
  const MapFrame& map = terrain.map;
  for (const Vec3& vertex : tin.vertices_m) {
    // On the ellipsoid straight below is so in the frame.
    const double depth_m =
        map.earth ? map.earth->exaggeration * (map.to_map(vertex).z * map.height_unit_m - base_m)
                  : vertex.z - base_m;
    base_z_m_.push_back(vertex.z - depth_m);
  }
  double area_m2 = 0;
  for (const auto& [a, b, c] : tin.triangles) {
    const Vec3 from = tin.vertices_m[a], ab = tin.vertices_m[b] - from,
               ac = tin.vertices_m[c] - from;
    area_m2 += std::abs(ab.x * ac.y - ab.y * ac.x); // twice
  }
  cell_m_ = std::sqrt(area_m2 / static_cast<double>(tin.triangles.size()));
}

double ClosedBlockWalk::depth_inside_m(ProfilePoint point, double tilt) const {
  const View& view = *view_;
  StraightWay way = StraightWay::to_eye(view, point);
  way.step.z += tilt * std::hypot(way.step.u, way.step.v);
  constexpr double kBeside_m = 1e-5;
  double deepest_m = -std::numeric_limits<double>::infinity();
  ways_.for_each(view, way, kBeside_m, [&](const TrianglePassage& of) {
    const Tin& tin = ways_.tin();
    std::array<double, 3> base_z{};
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t vertex = tin.triangles[of.triangle][k];
      Vec3 place = tin.vertices_m[vertex];
      place.z = base_z_m_[vertex];
      base_z[k] = to_profile_frame(view, place).z;
    }
    const auto inside = [&](double s) {
      const double base =
          base_z[0] + of.b(s) * (base_z[1] - base_z[0]) + of.c(s) * (base_z[2] - base_z[0]);
      return std::array{of.height_m(s) - way.z_m(s), way.z_m(s) - base};
    };
    // The lesser of two that are linear: greatest at an end, or where they are equal.
    const auto [top_low, base_low] = inside(of.low);
    const auto [top_high, base_high] = inside(of.high);
    deepest_m = std::max({deepest_m, std::min(top_low, base_low), std::min(top_high, base_high)});
    const double gap_low = top_low - base_low, gap_high = top_high - base_high;
    if ((gap_low < 0) != (gap_high < 0)) {
      const auto [top, base] = inside(of.low + gap_low / (gap_low - gap_high) * (of.high - of.low));
      deepest_m = std::max(deepest_m, std::min(top, base));
    }
  });
  return deepest_m;
}

} // namespace orograph
