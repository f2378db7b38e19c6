// SPDX-License-Identifier: GPL-3.0-or-later
#include "hidden_lines/lattice_in_work.hpp"

#include "dem/extent.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <variant>

namespace orograph {
namespace {

AcrossLattice across(const Grid& grid, const View& view, bool columns) {
  const auto& [first_vertex_m, column_step_m, row_step_m] = grid.plane();
  const double area = cross(column_step_m, row_step_m);
  const auto number = [&](Vec2 from_first) {
    return (columns ? cross(from_first, row_step_m) : cross(column_step_m, from_first)) / area;
  };
  return {number(view.depth_origin_m - first_vertex_m), number(view.right), number(view.forward)};
}

} // namespace

SectorLattice::SectorLattice(const Grid& of_grid, const View& of_view, const EarthStrips* strips)
    : grid(of_grid), view(of_view),
      order(strips ? LatticeOrder(*strips) : LatticeOrder(of_grid, of_view)) {
  if (strips) {
    find_depths_by_place();
    return;
  }
  strip = across(grid, view, !order.rows_are_strips());
  cell = across(grid, view, order.rows_are_strips());
  const auto& [first_vertex_m, column_step_m, row_step_m] = grid.plane();
  const double reach = reach_m(grid) + length(view.depth_origin_m);
  const double area = std::abs(cross(column_step_m, row_step_m));
  rounding = 64 * std::numeric_limits<double>::epsilon() * reach *
             (length(column_step_m) + length(row_step_m)) / area;
}

LatticeInWork::LatticeInWork(const SectorInWork& in_work)
    : SectorLattice(std::get<Grid>(in_work.terrain.surface), in_work.sector.view,
                    in_work.earth_strips),
      work(in_work) {}

LatticeOrder::Turn LatticeInWork::turn_of(const LinePictures& pictures, std::uint32_t line) const {
  SurfaceEdge edge = pictures.line(line).edge;
  if (is_on_wall(pictures.line(line).kind)) {
    edge = work.placed.border[work.triangle_of(line)].edge; // before that hides
  } else if (!pictures.is_edge(line)) {
    const std::uint32_t triangle = work.triangle_of(line), number = triangle / 2;
    const auto cells = static_cast<std::uint32_t>(grid.columns) - 1;
    return order.turn(static_cast<int>(number % cells), static_cast<int>(number / cells),
                      static_cast<Half>(triangle % 2));
  }
  const LatticeOrder::Turn turn = order.turn(edge);
  if (!LatticeOrder::is_on_line(turn) || !pictures.is_moved(edge)) return turn;
  // The lattice's line runs under the eye, across the view. Moved ahead of the near plane its edges
  // are in the strip of cells ahead, where what hides them begins at their nearer ends.
  const auto columns = static_cast<std::uint32_t>(grid.columns);
  const auto column = static_cast<int>(edge.from % columns),
             row = static_cast<int>(edge.from / columns);
  const bool rows = order.rows_are_strips();
  const int ahead = (rows ? row : column) - (strip.per_v > 0 ? 0 : 1);
  const int strips = (rows ? grid.rows : grid.columns) - 1;
  return ahead >= 0 && ahead < strips ? order.turn_of_nearer(ahead, rows ? column : row) : turn;
}

LatticeOrder::Places SectorLattice::places_of(double depth_m, const URange& shown) const {
  if (order.earth()) return places_of_depth(depth_m);
  const auto frame = [&](int column, int row) {
    const Vec2 at = grid.plane().position_m(column, row) - view.depth_origin_m;
    return Vec2{dot(at, view.right), dot(at, view.forward)};
  };
  const std::array<Vec2, 4> corners{frame(0, 0), frame(grid.columns - 1, 0),
                                    frame(grid.columns - 1, grid.rows - 1),
                                    frame(0, grid.rows - 1)};
  URange cut{shown.high_m, shown.low_m};
  bool any = false;
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec2 a = corners[i], b = corners[(i + 1) % 4];
    if ((a.y < depth_m) == (b.y < depth_m)) continue;
    const double u =
        std::clamp(a.x + (depth_m - a.y) / (b.y - a.y) * (b.x - a.x), shown.low_m, shown.high_m);
    cut = {std::min(cut.low_m, u), std::max(cut.high_m, u)};
    any = true;
  }
  if (!any) { // at the grid's very end, or beside it
    const auto [nearest, farthest] =
        std::minmax({corners[0].y, corners[1].y, corners[2].y, corners[3].y});
    if (depth_m < nearest || depth_m > farthest) return {0, 0};
    return {0, order.place_count() - 1};
  }
  const auto [low, high] =
      std::minmax({strip.at(cut.low_m, depth_m), strip.at(cut.high_m, depth_m)});
  constexpr double kBeside = 1.5; // cells: a span may begin in the strip beside
  return order.places_between(static_cast<int>(std::floor(low - kBeside)),
                              static_cast<int>(std::ceil(high + kBeside)));
}

void SectorLattice::find_depths_by_place() {
  const std::uint32_t count = order.place_count();
  farthest_up_to_m_.resize(count);
  nearest_from_m_.resize(count);
  const auto depths_of = [&](std::uint32_t place) {
    const int number = order.place(place).strip;
    return number == LatticeOrder::Place::kNone ? EarthStrips::Depths{kInfinity, -kInfinity}
                                                : order.earth()->depths_of(number);
  };
  double farthest_m = -kInfinity, nearest_m = kInfinity;
  for (std::uint32_t place = 0; place < count; ++place)
    farthest_up_to_m_[place] = farthest_m = std::max(farthest_m, depths_of(place).farthest_m);
  for (std::uint32_t place = count; place-- > 0;)
    nearest_from_m_[place] = nearest_m = std::min(nearest_m, depths_of(place).nearest_m);
}

// Before the first of them all strips are nearer, behind the last one all are farther.
LatticeOrder::Places SectorLattice::places_of_depth(double depth_m) const {
  const auto first =
                 std::ranges::lower_bound(farthest_up_to_m_, depth_m) - farthest_up_to_m_.begin(),
             end = std::ranges::upper_bound(nearest_from_m_, depth_m) - nearest_from_m_.begin();
  if (first >= end) return {0, 0};
  return {static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(end - 1)};
}

} // namespace orograph
