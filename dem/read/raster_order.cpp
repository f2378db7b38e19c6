// SPDX-License-Identifier: GPL-3.0-or-later
// A Grid's column step is one of the raster's pixel and line steps, as it is or the other way.
#include "dem/read/raster_order.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace orograph {
namespace {

// Far above the rounding of coordinates (1e-9 of a cell for 1 m cells at 5000 km), far below a
// cell.
constexpr double border_cells = 1e-6;

// Scores of a rotation by 45 degrees differ by rounding only; this is above that.
constexpr double equal_scores = 1e-9;

struct Turn {
  bool transposed;
  double column_sign, row_sign;
};

Vec2 column_step(const RasterLattice& lattice, const Turn& turn) {
  return turn.column_sign * (turn.transposed ? lattice.line_step : lattice.pixel_step);
}

Vec2 row_step(const RasterLattice& lattice, const Turn& turn) {
  return turn.row_sign * (turn.transposed ? lattice.pixel_step : lattice.line_step);
}

// 2 for columns due east and rows due south.
double score(Vec2 column, Vec2 row) {
  return column.x / length(column) - row.y / length(row);
}

Turn best_turn(const RasterLattice& lattice) {
  std::optional<Turn> best;
  double best_score = 0, best_north = 0;
  for (const bool transposed : {false, true})
    for (const double column_sign : {1., -1.})
      for (const double row_sign : {1., -1.}) {
        const Turn turn{transposed, column_sign, row_sign};
        const Vec2 column = column_step(lattice, turn), row = row_step(lattice, turn);
        if (cross(column, row) > 0) continue; // mirrored
        const double this_score = score(column, row), north = column.y / length(column);
        const bool tied = best && std::abs(this_score - best_score) <= equal_scores;
        if (!best || (tied ? north > best_north : this_score > best_score)) {
          best = turn;
          best_score = this_score;
          best_north = north;
        }
      }
  return *best;
}

struct Range {
  int first = 0, count = 0;
};

// With its vertex (0, 0) at (column, row) in rows of `width`.
void set_indices(GridOrder& order, std::ptrdiff_t width, std::ptrdiff_t column,
                 std::ptrdiff_t row) {
  const std::ptrdiff_t per_column = order.columns_reversed ? -1 : 1;
  const std::ptrdiff_t per_row = order.rows_reversed ? -width : width;
  order.per_pixel = order.transposed ? per_row : per_column;
  order.per_line = order.transposed ? per_column : per_row;
  if (order.columns_reversed) column += order.columns - 1;
  if (order.rows_reversed) row += order.rows - 1;
  order.start = row * width + column;
}

Range whole_numbers(double low, double high, int count) {
  const double last = count - 1;
  const double from = std::max(0., std::ceil(low - border_cells));
  const double to = std::min(last, std::floor(high + border_cells));
  if (!(from <= to)) return {};
  return {static_cast<int>(from), static_cast<int>(to - from) + 1};
}

} // namespace

bool spans_a_plane(const RasterLattice& lattice) {
  const double area = std::abs(cross(lattice.pixel_step, lattice.line_step));
  const double largest = length(lattice.pixel_step) * length(lattice.line_step);
  // Below this the angle between the two is rounding (a shear that leaves 1e-9 of a cell's width).
  return std::isfinite(lattice.first.x + lattice.first.y + largest) && area > 1e-9 * largest;
}

GridOrder grid_order(const RasterLattice& lattice) {
  const Turn turn = best_turn(lattice);
  GridOrder order;
  order.columns = turn.transposed ? lattice.lines : lattice.pixels;
  order.rows = turn.transposed ? lattice.pixels : lattice.lines;
  // Adding zero makes a zero of a negative zero.
  order.column_step = column_step(lattice, turn) + Vec2{0, 0};
  order.row_step = row_step(lattice, turn) + Vec2{0, 0};

  // A reversed axis begins at the raster's last.
  order.transposed = turn.transposed;
  order.columns_reversed = turn.column_sign < 0;
  order.rows_reversed = turn.row_sign < 0;
  const bool from_last_pixel = order.transposed ? order.rows_reversed : order.columns_reversed;
  const bool from_last_line = order.transposed ? order.columns_reversed : order.rows_reversed;
  order.first = lattice.position(from_last_pixel ? lattice.pixels - 1 : 0,
                                 from_last_line ? lattice.lines - 1 : 0);
  set_indices(order, order.columns, 0, 0);
  return order;
}

RasterLattice in_grid_order(const GridOrder& order) {
  return {order.columns, order.rows, order.first, order.column_step, order.row_step};
}

RasterWindow raster_window(const GridOrder& order, const RasterWindow& part) {
  RasterWindow window = part;
  if (order.columns_reversed) window.pixel = order.columns - part.pixel - part.pixels;
  if (order.rows_reversed) window.line = order.rows - part.line - part.lines;
  if (!order.transposed) return window;
  return {window.line, window.pixel, window.lines, window.pixels};
}

GridOrder order_within(const GridOrder& order, const RasterWindow& part, int width, int column,
                       int row) {
  GridOrder within = order;
  within.columns = part.pixels;
  within.rows = part.lines;
  set_indices(within, width, column, row);
  return within;
}

bool in_box(const RasterLattice& lattice, Vec2 position, const Box2& box) {
  const double slack =
      border_cells * std::min(length(lattice.pixel_step), length(lattice.line_step));
  return position.x >= box.low.x - slack && position.x <= box.high.x + slack &&
         position.y >= box.low.y - slack && position.y <= box.high.y + slack;
}

RasterWindow window_of(const RasterLattice& lattice, const Box2& box) {
  Box2 indices; // of the box's corners: x in pixels, y in lines
  for (const Vec2 corner : std::array<Vec2, 4>{box.low, box.high, Vec2{box.low.x, box.high.y},
                                               Vec2{box.high.x, box.low.y}})
    indices.include(lattice.index_of(corner));
  const Range pixels = whole_numbers(indices.low.x, indices.high.x, lattice.pixels);
  const Range lines = whole_numbers(indices.low.y, indices.high.y, lattice.lines);
  return {pixels.first, lines.first, pixels.count, lines.count};
}

RasterLattice part_of(const RasterLattice& lattice, const RasterWindow& window) {
  return {window.pixels, window.lines, lattice.position(window.pixel, window.line),
          lattice.pixel_step, lattice.line_step};
}

Box2 box_of(const RasterLattice& lattice) {
  Box2 box;
  for (const int pixel : {0, lattice.pixels - 1})
    for (const int line : {0, lattice.lines - 1}) box.include(lattice.position(pixel, line));
  return box;
}

} // namespace orograph
