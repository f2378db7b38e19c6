// SPDX-License-Identifier: GPL-3.0-or-later
// The extent of a TIN and of any surface, and the range of true heights.
#include "dem/extent.hpp"
#include "dem/tin.hpp"
#include "geometry/on_all_cores.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <span>

namespace orograph {
namespace {

constexpr std::size_t kBlock = 1024; // vertices
constexpr std::size_t kGroup = 64;   // blocks

// A TIN of walls alone has no ground: then all vertices count alike.
double mean_height_m(const Tin& tin) {
  double ground_m2 = 0, sum = 0, vertex_sum = 0;
  for (std::size_t t = 0; t < tin.triangles.size(); ++t) {
    throw_if_stopped(t);
    const auto& [a, b, c] = tin.triangles[t];
    const double height = (tin.vertices_m[a].z + tin.vertices_m[b].z + tin.vertices_m[c].z) / 3;
    const double area = plan_area_m2(tin, t);
    ground_m2 += area;
    sum += area * height;
    vertex_sum += height;
  }
  return ground_m2 > 0 ? sum / ground_m2 : vertex_sum / static_cast<double>(tin.triangles.size());
}

// At height 0: a missing vertex has a place as well.
Vec2 place(const Grid& grid, int column, int row) {
  const Vec3 at =
      std::visit([&](const auto& l) { return l.vertex_m(column, row, 0); }, grid.lattice);
  return {at.x, at.y};
}

// Lanes, because a single running minimum or sum has to be taken in order and therefore doesn't
// vectorize; stretch by stretch, since the processor hasn't registers for the bounds' and the sums'
// lanes at a time. Comparisons with NaN are false.
constexpr std::size_t kLanes = 16, kStretch = 1024;
using SumLanes = std::array<double, kLanes>;

template <class Value>
struct StretchBounds {
  Value low, high;
  std::size_t missing;
};
template <class Value>
StretchBounds<Value> bounds_of(std::span<const Value> stretch) {
  std::array<Value, kLanes> low, high;
  low.fill(std::numeric_limits<Value>::infinity());
  high.fill(-std::numeric_limits<Value>::infinity());
  const std::size_t whole = stretch.size() / kLanes * kLanes;
  for (std::size_t i = 0; i < whole; i += kLanes)
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      const Value h = stretch[i + lane];
      low[lane] = h < low[lane] ? h : low[lane];
      high[lane] = h > high[lane] ? h : high[lane];
    }
  for (std::size_t i = whole; i < stretch.size(); ++i) {
    low[0] = stretch[i] < low[0] ? stretch[i] : low[0];
    high[0] = stretch[i] > high[0] ? stretch[i] : high[0];
  }
  int missing = 0;
  for (const Value h : stretch) missing += h != h;
  return {*std::min_element(low.begin(), low.end()), *std::max_element(high.begin(), high.end()),
          static_cast<std::size_t>(missing)};
}

// `of(h)`: what a height counts.
template <class Value, class Of>
SumLanes plus(SumLanes sum, std::span<const Value> stretch, const Of& of) {
  const std::size_t whole = stretch.size() / kLanes * kLanes;
  for (std::size_t i = 0; i < whole; i += kLanes)
    for (std::size_t lane = 0; lane < kLanes; ++lane)
      sum[lane] += static_cast<double>(of(stretch[i + lane]));
  for (std::size_t i = whole; i < stretch.size(); ++i)
    sum[0] += static_cast<double>(of(stretch[i]));
  return sum;
}

template <class Value>
HeightRange range_of(const Heights<Value>& heights) {
  const std::span<const Value> all(heights);
  HeightRange out{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
                  0};
  SumLanes sum{};
  std::size_t missing = 0;
  for (std::size_t begin = 0; begin < all.size(); begin += kStretch) {
    const auto stretch = all.subspan(begin, std::min(kStretch, all.size() - begin));
    const StretchBounds<Value> bounds = bounds_of(stretch);
    out.low_m = std::min<double>(out.low_m, bounds.low);
    out.high_m = std::max<double>(out.high_m, bounds.high);
    missing += bounds.missing;
    sum = bounds.missing == 0 ? plus(sum, stretch, [](Value h) { return h; })
                              : plus(sum, stretch, [](Value h) { return h == h ? h : Value{0}; });
  }
  out.mean_m =
      std::accumulate(sum.begin(), sum.end(), 0.0) / static_cast<double>(all.size() - missing);
  return out;
}

} // namespace

SurfaceExtent extent_of(const Tin& tin) {
  SurfaceExtent extent;
  const std::span<const Vec3> vertices(tin.vertices_m);
  const auto block = [vertices](std::size_t i) {
    const std::size_t begin = i * kBlock;
    return vertices.subspan(begin, std::min(kBlock, vertices.size() - begin));
  };
  for (std::size_t i = 0; i * kBlock < vertices.size(); ++i) {
    if (i % kGroup == 0) throw_if_stopped();
    Box3 box;
    for (const Vec3& vertex : block(i)) box.include(vertex);
    extent.blocks.boxes.push_back(box);
    if (i % kGroup == 0) extent.blocks.groups.emplace_back();
    extent.blocks.groups.back().add(i, box);
    extent.box.include(box.low);
    extent.box.include(box.high);
  }
  extent.blocks.points = block;
  extent.mean_height_m = mean_height_m(tin);
  extent.valid = vertices.size();
  return extent;
}

double reach_m(const Surface& surface) {
  double reach = 0;
  if (const Grid* grid = std::get_if<Grid>(&surface)) {
    // On the ellipsoid a parallel bulges over its chord, and a mountain leans outwards.
    const double more = grid->is_on_earth() ? 1.25 : 1;
    for (const int row : {0, grid->rows - 1})
      for (const int column : {0, grid->columns - 1})
        reach = std::max(reach, more * length(place(*grid, column, row)));
  } else {
    for (const Vec3& vertex : std::get<Tin>(surface).vertices_m)
      reach = std::max(reach, std::hypot(vertex.x, vertex.y));
  }
  return reach;
}

SurfaceExtent extent_of(const Surface& surface) {
  return std::visit([](const auto& s) { return extent_of(s); }, surface);
}

GridSteps steps_of(const Grid& grid) {
  if (!grid.is_on_earth()) return {grid.plane().column_step_m, grid.plane().row_step_m};
  const int column = std::clamp(grid.columns / 2, 1, grid.columns - 1),
            row = std::clamp(grid.rows / 2, 1, grid.rows - 1);
  const Vec2 at = place(grid, column, row);
  return {at - place(grid, column - 1, row), at - place(grid, column, row - 1)};
}

double cell_size_m(const Grid& grid) {
  const GridSteps steps = steps_of(grid);
  return std::min(length(steps.column_m), length(steps.row_m));
}

double cell_size_m(const Tin& tin) {
  std::size_t count = 0;
  double ground_m2 = 0;
  for (std::size_t t = 0; t < tin.triangles.size(); ++t) {
    throw_if_stopped(t);
    const double area = plan_area_m2(tin, t);
    ground_m2 += area;
    count += area > 0;
  }
  if (count > 0) return std::sqrt(2 * ground_m2 / static_cast<double>(count));
  const Box3 box = extent_of(tin).box; // walls alone
  return std::hypot(box.high.x - box.low.x, box.high.y - box.low.y);
}

double cell_size_m(const Surface& surface) {
  return std::visit([](const auto& s) { return cell_size_m(s); }, surface);
}

HeightRange height_range(const Grid& grid) {
  return std::visit([](const auto& heights) { return range_of(heights); }, grid.heights_m);
}

} // namespace orograph
