// SPDX-License-Identifier: GPL-3.0-or-later
#include "profiles/lattice_order.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace orograph {
namespace {

// In a parallel view the eye is infinitely far off, on the side that its direction tells. Rays
// along the lines between cells meet none of them, and any side will do.
double far_off(double direction) {
  constexpr double kFarOff = std::numeric_limits<double>::infinity();
  return direction > 0 ? kFarOff : -kFarOff;
}

bool crosses_rows_more_steeply(const Grid& grid, const View& view) {
  const auto& [first_vertex_m, column_step_m, row_step_m] = grid.plane();
  const auto across = [&](Vec2 step) { // of the forward direction, to lines along the step
    return std::abs(cross(step, view.forward)) / length(step);
  };
  return across(column_step_m) >= across(row_step_m);
}

} // namespace

EyeInCells eye_in_cells(const Grid& grid, const View& view) {
  const auto& [first_vertex_m, column_step_m, row_step_m] = grid.plane();
  const double area = cross(column_step_m, row_step_m);
  const auto solve = [&](Vec2 v) {
    return Vec2{cross(v, row_step_m) / area, cross(column_step_m, v) / area};
  };
  if (!view.is_perspective()) {
    const Vec2 back = solve(view.x_per_v * view.right - view.forward);
    return {back.x, back.y, 0};
  }
  const Vec2 at = solve(view.depth_origin_m - first_vertex_m);
  return {at.x, at.y, view.eye_z_m / view.exaggeration};
}

LatticeOrder::LatticeOrder(const Grid& grid, const View& view)
    : LatticeOrder(grid.columns, grid.rows, eye_in_cells(grid, view), !view.is_perspective(),
                   crosses_rows_more_steeply(grid, view)) {}

LatticeOrder::LatticeOrder(int columns, int rows, const EyeInCells& eye, bool is_parallel,
                           bool rows_are_strips)
    : columns_(static_cast<std::uint32_t>(columns)), rows_are_strips_(rows_are_strips) {
  EyeInCells at = eye;
  eye_across_ = at.column - at.row;
  if (is_parallel) {
    at = {far_off(at.column), far_off(at.row), 0};
    eye_across_ = far_off(eye_across_);
  }
  strips_ = outwards(rows_are_strips ? at.row : at.column, (rows_are_strips ? rows : columns) - 1);
  cells_ = outwards(rows_are_strips ? at.column : at.row, (rows_are_strips ? columns : rows) - 1);
}

LatticeOrder::LatticeOrder(const EarthStrips& strips)
    : columns_(
          static_cast<std::uint32_t>((strips.are_rows() ? strips.cells() : strips.strips()) + 1)),
      rows_are_strips_(strips.are_rows()), earth_(&strips),
      strips_(outwards(strips.own() + 0.5, strips.strips())), cells_(outwards(-1, strips.cells())) {
}

LatticeOrder::Outwards LatticeOrder::outwards(double eye, int count) {
  if (eye < 0) return {eye, count, 0, -1};
  const int own = eye >= count ? count : static_cast<int>(std::floor(eye));
  return {eye, count, own, own - 1};
}

LatticeOrder::Place LatticeOrder::place(std::uint32_t number) const {
  const auto& [eye, count, first_plus, first_minus] = strips_;
  if (number < strips_.minus_place()) {
    const int strip = first_plus + static_cast<int>(number);
    // A line that isn't behind the eye has its place on the other side.
    return {strip > eye ? strip : Place::kNone, strip < count ? strip : Place::kNone};
  }
  const int strip = first_minus - static_cast<int>(number - strips_.minus_place());
  return {strip + 1 <= eye ? strip + 1 : Place::kNone, strip};
}

LatticeOrder::Places LatticeOrder::places_between(int low, int high) const {
  const int last = strips_.count;
  low = std::clamp(low, 0, last);
  high = std::clamp(high, 0, last);
  Places out{std::numeric_limits<std::uint32_t>::max(), 0};
  const auto add = [&](std::uint32_t place) {
    out = {std::min(out.first, place), std::max(out.last, place)};
  };
  // Both sides' places rise outwards; the eye's own strip, and the strips beside it, come first.
  for (const int at :
       {low, high, strips_.first_plus, strips_.first_minus, strips_.first_minus + 1}) {
    if (at < low || at > high) continue;
    add(strips_.place_of_line(at));
    if (at < last) add(strips_.place_of_cell(at));
  }
  return out;
}

LatticeOrder::Turn LatticeOrder::turn(SurfaceEdge edge) const {
  const int column = static_cast<int>(edge.from % columns_),
            row = static_cast<int>(edge.from / columns_);
  const std::uint32_t step = edge.to - edge.from;
  const bool along_row = step == 1, along_column = step == columns_;
  const int strip = rows_are_strips_ ? row : column, cell = rows_are_strips_ ? column : row;
  if (!along_row && !along_column)
    return turn_at(strips_.place_of_cell(strip), place_of_cell(strip, cell), Step::diagonal);
  if (along_row == rows_are_strips_)
    return (Turn{strips_.place_of_line(strip)} << kPlaceBits) | cells_.place_of_cell(cell);
  return turn_of_upright(strip, cell);
}

LatticeOrder::Turn LatticeOrder::turn_of_upright(int strip, int cell) const {
  const std::uint32_t place = strips_.place_of_cell(strip);
  if (!earth_) return turn_at(place, cells_.place_of_line(cell), Step::upright);
  // The cells before it and behind it in number, one of which is in front of it.
  const bool falls = earth_->falls(strip, cell);
  if (cell == 0)
    return turn_at(place, earth_->place(strip, 0), falls ? Step::upright_behind : Step::upright);
  if (cell == earth_->cells())
    return turn_at(place, earth_->place(strip, cell - 1),
                   falls ? Step::other_upright : Step::upright_behind);
  return falls ? turn_at(place, earth_->place(strip, cell - 1), Step::other_upright)
               : turn_at(place, earth_->place(strip, cell), Step::upright);
}

LatticeOrder::Turn LatticeOrder::turn(int column, int row, Half half) const {
  const int strip = rows_are_strips_ ? row : column, cell = rows_are_strips_ ? column : row;
  const bool is_near = (half == Half::lower) == is_lower_near(column, row);
  return turn_at(strips_.place_of_cell(strip), place_of_cell(strip, cell),
                 is_near ? Step::near : Step::far);
}

} // namespace orograph
