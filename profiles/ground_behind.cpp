// SPDX-License-Identifier: GPL-3.0-or-later
// In cell coordinates the ray's ground line is straight. Its next crossings with a column line, a
// row line and a diagonal (column - row constant) are stepped from one to the next, in order of
// depth.
#include "profiles/ground_behind.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace orograph {
namespace {

// Crossings with one family of lines at whole numbers.
class Crossings {
public:
  Crossings(double at, double per_m)
      : start_(at), per_m_(per_m), line_(per_m > 0 ? std::floor(at) + 1 : std::ceil(at) - 1) {}

  double distance_m() const {
    return per_m_ == 0 ? std::numeric_limits<double>::infinity() : (line_ - start_) / per_m_;
  }
  int line() const { return static_cast<int>(line_); }
  void pass() { line_ += per_m_ > 0 ? 1 : -1; }

private:
  double start_, per_m_, line_;
};

template <class Height>
double between(const Grid& grid, const std::vector<Height>& heights, int column, int row, int right,
               int down, double share) {
  if (column < 0 || row < 0 || column + right >= grid.columns || row + down >= grid.rows)
    return std::numeric_limits<double>::quiet_NaN();
  const double from = heights[grid.index(column, row)];
  return from + share * (heights[grid.index(column + right, row + down)] - from);
}

} // namespace

GroundBehindGrid::GroundBehindGrid(const Grid& grid, const View& view) : grid_(grid), view_(view) {
  const double area = cross(grid.column_step_m, grid.row_step_m);
  per_column_ = (1 / area) * Vec2{grid.row_step_m.y, -grid.row_step_m.x};
  per_row_ = (1 / area) * Vec2{-grid.column_step_m.y, grid.column_step_m.x};
}

bool GroundBehindGrid::rises_within(SurfaceEdge, ProfilePoint from, double reach_m) const {
  const Vec2 from_first =
      view_.depth_origin_m + from.u * view_.right + from.v * view_.forward - grid_.first_vertex_m;
  const Vec2 per_m =
      view_.is_perspective() ? (from.u / from.v) * view_.right + view_.forward : view_.forward;
  const double column = dot(per_column_, from_first), row = dot(per_row_, from_first);
  const double column_per_m = dot(per_column_, per_m), row_per_m = dot(per_row_, per_m);
  // Along the ray Y stays what it is.
  const double z_per_m = view_.is_perspective() ? (from.z - view_.eye_z_m) / from.v
                                                : -view_.sin_elevation / view_.cos_elevation;
  // The silhouette's own edge is in reach of rounding: a thousandth of a cell is not behind it.
  const double least_m = 1e-3 / std::max(std::abs(column_per_m), std::abs(row_per_m));

  Crossings columns(column, column_per_m), rows(row, row_per_m),
      diagonals(column - row, column_per_m - row_per_m);
  return std::visit(
      [&](const auto& heights) {
        for (;;) {
          Crossings* next = &columns;
          if (rows.distance_m() < next->distance_m()) next = &rows;
          if (diagonals.distance_m() < next->distance_m()) next = &diagonals;
          const double distance = next->distance_m();
          if (!(distance <= reach_m)) return false;
          const double c = column + distance * column_per_m, r = row + distance * row_per_m;
          const int whole_c = static_cast<int>(std::floor(c)),
                    whole_r = static_cast<int>(std::floor(r));
          const double surface_m =
              next == &columns ? between(grid_, heights, next->line(), whole_r, 0, 1, r - whole_r)
              : next == &rows
                  ? between(grid_, heights, whole_c, next->line(), 1, 0, c - whole_c)
                  : between(grid_, heights, whole_c, whole_c - next->line(), 1, 1, c - whole_c);
          if (std::isnan(surface_m)) return false;
          if (distance > least_m && surface_m * view_.exaggeration >= from.z + distance * z_per_m)
            return true;
          next->pass();
        }
      },
      grid_.heights_m);
}

GroundBehind::GroundBehind(const Surface& surface, const View& view)
    : ground_(std::holds_alternative<Grid>(surface)
                  ? std::variant<GroundBehindGrid, GroundBehindTin>(std::in_place_index<0>,
                                                                    std::get<Grid>(surface), view)
                  : std::variant<GroundBehindGrid, GroundBehindTin>(std::in_place_index<1>,
                                                                    std::get<Tin>(surface), view)) {
}

} // namespace orograph
