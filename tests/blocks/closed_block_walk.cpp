// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/blocks/closed_block_walk.hpp"

#include "dem/approximate/tin_of_grid.hpp"
#include "placing/vertex_values.hpp"
#include "reference/spatial.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace orograph {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

} // namespace

ClosedBlockWalk::ClosedBlockWalk(const TerrainData& terrain, const PlacedView& placed,
                                 const View& view)
    : view_(view) {
  // Triangles by the terrain's own numbers of vertices.
  const Grid* grid = std::get_if<Grid>(&terrain.surface);
  std::vector<std::array<std::uint32_t, 3>> triangles;
  if (grid) {
    const auto columns = static_cast<std::uint32_t>(grid->columns);
    for (std::uint32_t r = 0; r + 1 < static_cast<std::uint32_t>(grid->rows); ++r)
      for (std::uint32_t c = 0; c + 1 < columns; ++c) {
        const std::uint32_t first = r * columns + c, across = first + columns + 1;
        for (const std::uint32_t beside : {first + columns, first + 1}) {
          const auto there = [&](std::uint32_t vertex) {
            return !std::isnan(grid->vertex_m(std::size_t{vertex}).z);
          };
          if (there(first) && there(beside) && there(across))
            triangles.push_back({first, beside, across});
        }
      }
  } else {
    for (const auto& of : std::get<Tin>(terrain.surface).triangles) triangles.push_back(of);
  }
  const VertexValues heights = heights_of(terrain);
  const double exaggeration = terrain.map.earth ? terrain.map.earth->exaggeration : 1;
  for (const auto& of : triangles) {
    std::array<Corner, 3>& prism = prisms_.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      double height_m = 0;
      heights(of[k], std::span(&height_m, 1));
      Vec3 at = grid ? grid->vertex_m(std::size_t{of[k]})
                     : std::get<Tin>(terrain.surface).vertices_m[of[k]];
      prism[k].top = to_profile_frame(view, at);
      at.z -= exaggeration * (height_m - *placed.block_base_m);
      prism[k].base_z = to_profile_frame(view, at).z;
    }
  }
}

double ClosedBlockWalk::depth_inside_m(ProfilePoint point, double tilt) const {
  const Spatial from = of(point);
  Spatial step = view_.is_perspective() ? Spatial{0, 0, view_.eye_z_m} - from
                                        : Spatial{view_.x_per_v, -1, view_.y_per_v / view_.y_per_z};
  step.z += tilt * std::hypot(step.u, step.v);
  const double end = view_.is_perspective() ? 1 - view_.near_m / point.v : kInfinity;
  double deepest_m = -kInfinity;
  for (const auto& prism : prisms_) {
    const Spatial a = of(prism[0].top), ab = of(prism[1].top) - a, ac = of(prism[2].top) - a;
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
      const double top = a.z + b * ab.z + c * ac.z, base = prism[0].base_z +
                                                           b * (prism[1].base_z - prism[0].base_z) +
                                                           c * (prism[2].base_z - prism[0].base_z);
      return std::array{top - z, z - base};
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
