// SPDX-License-Identifier: GPL-3.0-or-later
#include "profiles/grid_lines.hpp"

#include "profiles/mesh.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>

namespace orograph {

bool is_upright(const Grid& grid) {
  return !grid.is_on_earth() && grid.plane().column_step_m.y == 0 && grid.plane().row_step_m.x == 0;
}

LinePlaces::LinePlaces(const Grid& grid, const View& view) {
  const auto& [first_m, column_step_m, row_step_m] = grid.plane();
  for (int c = -kBeside; c < grid.columns + kBeside; ++c) {
    const double x = first_m.x + c * column_step_m.x - view.depth_origin_m.x;
    column_u.push_back(x * view.right.x);
    column_v.push_back(x * view.forward.x);
  }
  for (int r = -kBeside; r < grid.rows + kBeside; ++r) {
    const double y = first_m.y + r * row_step_m.y - view.depth_origin_m.y;
    row_u.push_back(y * view.right.y);
    row_v.push_back(y * view.forward.y);
  }
}

std::vector<double> row_depths(const Grid& grid, const View& view) {
  if (!is_upright(grid) || (view.forward.x != 0 && view.forward.y != 0)) return {};
  const LinePlaces places(grid, view);
  std::vector<double> depths_m;
  if (view.forward.x == 0)
    for (int row = 0; row < grid.rows; ++row) depths_m.push_back(places.v(0, row));
  else
    for (int column = 0; column < grid.columns; ++column) depths_m.push_back(places.v(column, 0));
  if (depths_m.front() > depths_m.back()) std::ranges::reverse(depths_m);
  const bool rise = std::ranges::adjacent_find(depths_m, std::greater_equal<>()) == depths_m.end();
  return rise ? depths_m : std::vector<double>();
}

namespace {

// The cut along a row. What is said of a row here holds for a column, with columns for rows.
struct Row {
  bool is_column;
  int number;
};

std::optional<int> place_of(double depth_m, double first_m, double second_m, int count) {
  const double place = std::round((depth_m - first_m) / (second_m - first_m));
  if (!(place >= 0 && place < count)) return std::nullopt;
  return static_cast<int>(place);
}

std::optional<Row> row_in_plane(const Grid& grid, const View& view, const LinePlaces& places,
                                double depth_m) {
  if (view.forward.x == 0) {
    const auto row = place_of(depth_m, places.v(0, 0), places.v(0, 1), grid.rows);
    if (row && places.v(0, *row) == depth_m) return Row{false, *row};
  } else if (view.forward.y == 0) {
    const auto column = place_of(depth_m, places.v(0, 0), places.v(1, 0), grid.columns);
    if (column && places.v(*column, 0) == depth_m) return Row{true, *column};
  }
  return std::nullopt;
}

template <class Height>
class RowCut {
public:
  RowCut(const Grid& grid, const Heights<Height>& heights, const View& view,
         const TriangleSet& level, const LinePlaces& places, Row row)
      : mesh_{grid, grid.plane(), heights, view}, level_(level), row_(row),
        count_(row.is_column ? grid.rows : grid.columns),
        rows_(row.is_column ? grid.columns : grid.rows),
        first_(row.is_column ? grid.index(row.number, 0) : grid.index(0, row.number)),
        step_(row.is_column ? static_cast<std::size_t>(grid.columns) : 1),
        u_((row.is_column ? places.row_u : places.column_u).data() + LinePlaces::kBeside),
        u_of_row_((row.is_column
                       ? places.column_u
                       : places.row_u)[static_cast<std::size_t>(row.number + LinePlaces::kBeside)]),
        per_vertex_(u_[1] - u_[0]) {}

  void cut(double depth_m, const URange& range, Profile& out) const {
    // Vertices first to last, rounding and those next to the range included.
    const double a = (range.low_m - u_of_row_ - u_[0]) / per_vertex_,
                 b = (range.high_m - u_of_row_ - u_[0]) / per_vertex_;
    const double first_asked = std::floor(std::min(a, b)) - 1,
                 last_asked = std::ceil(std::max(a, b)) + 1;
    if (!(first_asked < count_ && last_asked >= 0)) return;
    const int first = static_cast<int>(std::max(0.0, first_asked)),
              last = static_cast<int>(std::min(count_ - 1.0, last_asked));
    const auto count = static_cast<std::size_t>(last - first + 1);
    const std::size_t so_far = out.size();
    out.resize(so_far + count);
    const bool rises = per_vertex_ > 0;
    fill(rises ? first : last, rises ? 1 : -1, count, depth_m, &out.u_m[so_far], &out.z_m[so_far]);
    Span* const after = &out.after[so_far];
    if (level_.empty() && is_whole(first, last))
      std::fill(after, after + count, Span::slope);
    else
      for (std::size_t k = 0; k + 1 < count; ++k) {
        const int from_left = static_cast<int>(k);
        after[k] = span(rises ? first + from_left : last - from_left - 1);
      }
    after[count - 1] = Span::gap;
  }

private:
  std::size_t index(int i) const { return first_ + static_cast<std::size_t>(i) * step_; }

  void fill(int begin, int direction, std::size_t count, double depth_m, double* u,
            double* z) const {
    const Height* height = mesh_.heights.data() + index(begin);
    const double* place = u_ + begin;
    const std::ptrdiff_t step = direction * static_cast<std::ptrdiff_t>(step_);
    const double u_of_row = u_of_row_, exaggeration = mesh_.view.exaggeration;
    const auto n = static_cast<std::ptrdiff_t>(count);
    // Heights side by side get to the vector units, here and below: 3 rather than 5 ns a vertex.
    if (step == 1)
      for (std::ptrdiff_t k = 0; k < n; ++k) z[k] = height[k] * exaggeration;
    else
      for (std::ptrdiff_t k = 0; k < n; ++k) z[k] = height[k * step] * exaggeration;
    for (std::ptrdiff_t k = 0; k < n; ++k) u[k] = place[k * direction] + u_of_row;
    if (const FrameDrop& drop = mesh_.view.drop; drop.any())
      for (std::ptrdiff_t k = 0; k < n; ++k) z[k] -= drop.at(u[k], depth_m);
  }

  // Whether none of the vertices is missing, nor any of those beside them.
  bool is_whole(int first, int last) const {
    const Height* const row = mesh_.heights.data() + index(first);
    const std::size_t to_row = row_.is_column ? 1 : static_cast<std::size_t>(mesh_.grid.columns);
    const std::size_t count = static_cast<std::size_t>(last - first + 1);
    const bool has_before = row_.number > 0, has_behind = row_.number + 1 < rows_;
    return !misses(row, count) && !(has_before && misses(row - to_row, count)) &&
           !(has_behind && misses(row + to_row, count));
  }
  bool misses(const Height* height, std::size_t count) const {
    std::uint32_t missing = 0; // counted in the way that gets to the vector units
    if (step_ == 1) {
      for (std::size_t k = 0; k < count; ++k)
        if (height[k] != height[k]) ++missing;
    } else {
      for (std::size_t k = 0; k < count; ++k)
        if (height[k * step_] != height[k * step_]) ++missing;
    }
    return missing > 0;
  }

  // What is between vertex i and the next: it is there if either triangle is, level if either is.
  Span span(int i) const {
    const std::size_t here = index(i), next = here + step_;
    if (std::isnan(mesh_.heights[here]) || std::isnan(mesh_.heights[next])) return Span::gap;
    const SurfaceEdge edge{static_cast<std::uint32_t>(here), static_cast<std::uint32_t>(next)};
    Span found = Span::gap;
    for (const bool left : {true, false})
      if (const auto side = mesh_.if_there(side_of(mesh_.grid, edge, left)))
        found = std::max(found, span_in(side->triangle));
    return found;
  }
  Span span_in(const CellHalf& t) const {
    const bool is_level =
        !level_.empty() && level_.has(grid_triangle(mesh_.grid, t.column, t.row, t.half));
    return is_level ? Span::level : Span::slope;
  }

  GridMesh<PlaneLattice, Height> mesh_;
  const TriangleSet& level_;
  Row row_;
  int count_, rows_;  ///< vertices in it, and rows like it
  std::size_t first_; ///< index of its first vertex
  std::size_t step_;  ///< from one to the next
  const double* u_;   ///< without the row's own
  double u_of_row_;
  double per_vertex_;
};

} // namespace

bool cut_row(const Grid& grid, const View& view, const TriangleSet& level, const LinePlaces& places,
             double depth_m, const URange& range, Profile& out) {
  const std::optional<Row> row = row_in_plane(grid, view, places, depth_m);
  if (!row) return false;
  std::visit(
      [&](const auto& heights) {
        RowCut(grid, heights, view, level, places, *row).cut(depth_m, range, out);
      },
      grid.heights_m);
  return true;
}

} // namespace orograph
