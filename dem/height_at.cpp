// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/height_at.hpp"

#include "geometry/on_all_cores.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace orograph {
namespace {

// Columns and rows are reckoned with the roundings of the ground position. A point that close to a
// column or row line is on it, so that the grid's border and its vertices are where they should be.
double on_line_if_close(double number) {
  const double line = std::round(number);
  return std::abs(number - line) <= 1e-9 ? line : number;
}

// The first and the last cell (or row of cells) of `cells` that hold a number, on a line both.
int first_cell(double number) {
  return std::max(static_cast<int>(std::ceil(number)) - 1, 0);
}
int last_cell(double number, int cells) {
  return std::min(static_cast<int>(std::floor(number)), cells - 1);
}

// On a triangle that holds the point, its edges included; a point that is off an edge by the
// rounding of coordinates, or of its own place, is on it. A triangle that runs clockwise holds
// none, nor does a wall.
std::optional<double> height_in(const std::array<Vec3, 3>& corners, Vec2 ground_m,
                                double rounding_m = 0) {
  constexpr double kRounding = 1e-12;
  const auto from_point = [&](std::size_t i) {
    return Vec2{corners[i].x - ground_m.x, corners[i].y - ground_m.y};
  };
  const Vec2 p = from_point(0), q = from_point(1), r = from_point(2);
  const double at_p = cross(q, r), at_q = cross(r, p), at_r = cross(p, q);
  const double twice_area = at_p + at_q + at_r;
  if (!(twice_area > 0)) return std::nullopt;
  const double slack = kRounding * twice_area + rounding_m * (length(p) + length(q) + length(r));
  if (at_p < -slack || at_q < -slack || at_r < -slack) return std::nullopt;
  return (at_p * corners[0].z + at_q * corners[1].z + at_r * corners[2].z) / twice_area;
}

// Of some vertex about a cell, which may lie outside of the grid.
std::optional<double> height_near(const Grid& grid, int column, int row) {
  for (const int reach : {0, 3, 12}) {
    const int step = std::max(reach / 3, 1);
    for (int r = row - reach; r <= row + reach; r += step)
      for (int c = column - reach; c <= column + reach; c += step) {
        const double z_m =
            grid.vertex_m(std::clamp(c, 0, grid.columns - 1), std::clamp(r, 0, grid.rows - 1)).z;
        if (!std::isnan(z_m)) return z_m;
      }
  }
  return std::nullopt;
}

// On the ellipsoid vertices lean: what is above a point lies in another cell than the point itself,
// by a height over the earth's radius for each metre from the origin.
std::optional<double> height_on_earth(const Grid& grid, Vec2 ground_m,
                                      std::optional<Vec3> nearby_m = std::nullopt) {
  const EarthLattice& earth = grid.earth();
  constexpr double kRounding_m = 1e-8; // of a place that LocalFrame tells, and some
  const auto in_cell = [&](int column, int row) -> std::optional<double> {
    if (column < 0 || row < 0 || column + 1 >= grid.columns || row + 1 >= grid.rows)
      return std::nullopt;
    const Vec3 corner = grid.vertex_m(column, row), opposite = grid.vertex_m(column + 1, row + 1);
    const auto lower =
        height_in({corner, grid.vertex_m(column, row + 1), opposite}, ground_m, kRounding_m);
    return lower ? lower
                 : height_in({corner, opposite, grid.vertex_m(column + 1, row)}, ground_m,
                             kRounding_m);
  };
  // Where the ellipsoid is there, to a parabola, or what is as far above it as the place nearby;
  // then where the terrain was found.
  const double twice_axis_m = 2 * earth.frame().ellipsoid().semi_major_axis_m;
  double z_m = -dot(ground_m, ground_m) / twice_axis_m;
  if (nearby_m) {
    const Vec2 there{nearby_m->x, nearby_m->y};
    z_m += nearby_m->z + dot(there, there) / twice_axis_m;
  }
  constexpr int kTries = 5; // each is some thirty times nearer, or more
  for (int i = 0; i < kTries; ++i) {
    const Vec2 at = earth.column_row_at({ground_m.x, ground_m.y, z_m});
    if (!(std::isfinite(at.x) && std::isfinite(at.y))) return std::nullopt;
    const int column = static_cast<int>(std::floor(std::clamp(at.x, -9.0, grid.columns + 9.0))),
              row = static_cast<int>(std::floor(std::clamp(at.y, -9.0, grid.rows + 9.0)));
    if (const auto found = in_cell(column, row)) return found;
    const auto near_m = height_near(grid, column, row);
    const bool is_last = !near_m || *near_m == z_m;
    // From a place nearby another guess takes less time than the cells around. What lies on an edge
    // is then found on either of its triangles, by roundings.
    if (!nearby_m || i > 0 || is_last)
      for (const int reach : {1, 3})
        for (int r = row - reach; r <= row + reach; ++r)
          for (int c = column - reach; c <= column + reach; ++c)
            if (const auto found = in_cell(c, r)) return found;
    if (is_last) break;
    z_m = *near_m;
  }
  return std::nullopt;
}

} // namespace

std::optional<double> height_at(const Grid& grid, Vec2 ground_m) {
  if (grid.is_on_earth()) return height_on_earth(grid, ground_m);
  return height_at(grid, ground_m, [&](int column, int row) { return grid.height_m(column, row); });
}

std::optional<double> height_at(const Grid& grid, Vec2 ground_m, Vec3 nearby_m) {
  return grid.is_on_earth() ? height_on_earth(grid, ground_m, nearby_m) : height_at(grid, ground_m);
}

std::optional<double> height_at(const Grid& grid, Vec2 ground_m,
                                const std::function<double(int, int)>& height_m) {
  // Solve ground = first + c * column_step + r * row_step.
  const auto& [first_vertex_m, column_step_m, row_step_m] = grid.plane();
  const Vec2 from_first = ground_m - first_vertex_m;
  const double area = cross(column_step_m, row_step_m);
  const double c = on_line_if_close(cross(from_first, row_step_m) / area);
  const double r = on_line_if_close(cross(column_step_m, from_first) / area);
  if (!(c >= 0 && r >= 0 && c <= grid.columns - 1 && r <= grid.rows - 1)) return std::nullopt;

  for (int row = first_cell(r); row <= last_cell(r, grid.rows - 1); ++row)
    for (int column = first_cell(c); column <= last_cell(c, grid.columns - 1); ++column) {
      const double east = c - column, south = r - row;
      const double corner = height_m(column, row);
      const double opposite = height_m(column + 1, row + 1);
      // A missing vertex makes its triangle's height NaN, with a weight of zero as well.
      const double upper =
          (1 - east) * corner + south * opposite + (east - south) * height_m(column + 1, row);
      const double lower =
          (1 - south) * corner + east * opposite + (south - east) * height_m(column, row + 1);
      if (east >= south && !std::isnan(upper)) return upper;
      if (south >= east && !std::isnan(lower)) return lower;
    }
  return std::nullopt;
}

std::optional<double> height_at(const Tin& tin, Vec2 ground_m) {
  constexpr double kNone = -std::numeric_limits<double>::infinity();
  std::vector<double> highest(tasks_of_triangles(tin), kNone);
  on_all_cores(highest.size(), [&](std::size_t task) {
    for (const std::uint32_t t : triangles_of_task(tin, task)) {
      const auto& [a, b, c] = tin.triangles[t];
      const Vec3 &p = tin.vertices_m[a], &q = tin.vertices_m[b], &r = tin.vertices_m[c];
      if (std::max({p.x, q.x, r.x}) < ground_m.x || std::min({p.x, q.x, r.x}) > ground_m.x)
        continue;
      if (const auto height = height_in({p, q, r}, ground_m))
        highest[task] = std::max(highest[task], *height);
    }
  });
  const double height = highest.empty() ? kNone : *std::ranges::max_element(highest);
  return height > kNone ? std::optional(height) : std::nullopt;
}

std::optional<double> height_at(const Surface& surface, Vec2 ground_m) {
  return std::visit([&](const auto& s) { return height_at(s, ground_m); }, surface);
}

} // namespace orograph
