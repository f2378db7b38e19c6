// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/stability/sight_through_triangles.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace orograph {
namespace {

constexpr long double kLongInfinity = std::numeric_limits<long double>::infinity();

// A place of a triangle in the upright plane of the ray.
struct OnSection {
  long double depth, z;
};

} // namespace

SightThroughTriangles::SightThroughTriangles(const Grid& grid, const View& view) : view_(view) {
  const PlaneLattice& lattice = grid.plane();
  long double reach_m = 0;
  const auto vertex = [&](int column, int row) -> LongPlace {
    const long double c = column, r = row;
    const long double x = lattice.first_vertex_m.x + c * lattice.column_step_m.x +
                          r * lattice.row_step_m.x - view.depth_origin_m.x;
    const long double y = lattice.first_vertex_m.y + c * lattice.column_step_m.y +
                          r * lattice.row_step_m.y - view.depth_origin_m.y;
    reach_m = std::max(reach_m, std::abs(x) + std::abs(y));
    return {x * view.right.x + y * view.right.y, x * view.forward.x + y * view.forward.y,
            static_cast<long double>(grid.height_m(column, row)) * view.exaggeration};
  };
  for (int row = 0; row + 1 < grid.rows; ++row)
    for (int column = 0; column + 1 < grid.columns; ++column) {
      const LongPlace north_west = vertex(column, row), south_east = vertex(column + 1, row + 1);
      for (const LongPlace& third : {vertex(column + 1, row), vertex(column, row + 1)})
        if (!std::isnan(north_west.z) && !std::isnan(south_east.z) && !std::isnan(third.z))
          triangles_.push_back({north_west, south_east, third});
    }
  rounding_m_ = 16 * static_cast<long double>(std::numeric_limits<double>::epsilon()) *
                (reach_m + std::abs(lattice.first_vertex_m.x) + std::abs(lattice.first_vertex_m.y) +
                 std::abs(view.depth_origin_m.x) + std::abs(view.depth_origin_m.y));
}

long double SightThroughTriangles::above(const LongPlace& place, long double nearer_m) const {
  const bool perspective = view_.is_perspective();
  // The ray in plan, and a place of it: the eye in perspective.
  const long double along_u = perspective ? place.u : -static_cast<long double>(view_.x_per_v);
  const long double along_v = perspective ? place.v : 1;
  const long double from_u = perspective ? 0 : place.u, from_v = perspective ? 0 : place.v;
  const long double length = std::hypot(along_u, along_v);
  const auto y_of = [&](const OnSection& at) -> long double {
    return perspective ? (at.z - view_.eye_z_m) / at.depth
                       : at.z * view_.y_per_z + at.depth * view_.y_per_v;
  };
  const long double nearest = perspective ? view_.near_m : -kLongInfinity;
  const long double in_front = place.v - nearer_m;
  long double greatest = -kLongInfinity;
  for (const auto& corners : triangles_) {
    std::array<long double, 3> aside{};
    for (std::size_t i = 0; i < 3; ++i)
      aside[i] = ((corners[i].u - from_u) * along_v - (corners[i].v - from_v) * along_u) / length;
    if (std::min({aside[0], aside[1], aside[2]}) > 0 ||
        std::max({aside[0], aside[1], aside[2]}) < 0)
      continue;
    OnSection begin{kLongInfinity, 0}, end{-kLongInfinity, 0};
    const auto meet = [&](const OnSection& at) {
      if (at.depth < begin.depth) begin = at;
      if (at.depth > end.depth) end = at;
    };
    for (std::size_t i = 0; i < 3; ++i) {
      const LongPlace &a = corners[i], &b = corners[(i + 1) % 3];
      const long double aside_a = aside[i], aside_b = aside[(i + 1) % 3];
      if (aside_a == 0) meet({a.v, a.z});
      if ((aside_a < 0) == (aside_b < 0) || aside_a == 0 || aside_b == 0) continue;
      const long double t = aside_a / (aside_a - aside_b);
      meet({a.v + t * (b.v - a.v), a.z + t * (b.z - a.z)});
    }
    if (!(begin.depth < in_front) || end.depth <= nearest) continue;
    if (begin.depth < nearest) {
      const long double t = (nearest - begin.depth) / (end.depth - begin.depth);
      begin = {nearest, begin.z + t * (end.z - begin.z)};
    }
    greatest = std::max(greatest, y_of(begin));
    if (end.depth < in_front) greatest = std::max(greatest, y_of(end));
  }
  return y_of({place.v, place.z}) - greatest;
}

} // namespace orograph
