// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/levels/refine.hpp"

#include "dem/levels/stretched_lattice.hpp"
#include "geometry/on_all_cores.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <variant>
#include <vector>

namespace orograph {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

// At a height between two others, of which one may be missing: that of the parabola through the
// three, but none at a summit or in a hollow, and at most three times the lesser rise, which keeps
// a cubic within its ends (Fritsch and Carlson, 1980, lemma 2).
double slope(double before, double at, double after) {
  const double rise = at - before, next = after - at;
  if (std::isnan(rise)) return std::isnan(next) ? 0 : next;
  if (std::isnan(next)) return rise;
  if (!(rise > 0 ? next > 0 : rise < 0 && next < 0)) return 0;
  const double most = 3 * std::min(std::abs(rise), std::abs(next));
  return std::copysign(std::min(0.5 * std::abs(rise + next), most), rise);
}

// Between the two in the middle; NaN where one of these is.
double between(double before, double from, double to, double after, double share) {
  const double rest = 1 - share;
  const double height = from + (to - from) * share * share * (3 - 2 * share) +
                        slope(before, from, to) * share * rest * rest -
                        slope(from, to, after) * share * share * rest;
  if (std::isnan(height)) return kNone;
  return std::clamp(height, std::min(from, to), std::max(from, to)); // whatever rounding does
}

// Corners of a cell, by column and row.
struct Corners {
  double west_north, east_north, west_south, east_south;
};

// A level triangle beside one that isn't: how much of its rise is left at a point of the other, of
// which the first share is that of its own corner. All along its two sides, nothing on the
// diagonal.
double share_of_rise(double own, double first, double second) {
  return own / (own + 4 * first * second);
}

template <class Height>
class Refiner {
public:
  Refiner(const Grid& grid, const Heights<Height>& heights, int parts)
      : grid_(grid), heights_(heights), parts_(parts), columns_((grid.columns - 1) * parts + 1),
        rows_((grid.rows - 1) * parts + 1),
        on_rows_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(grid.rows)),
        on_columns_(static_cast<std::size_t>(grid.columns) * static_cast<std::size_t>(rows_)) {
    on_all_cores(static_cast<std::size_t>(grid.rows), [&](std::size_t j) {
      const int row = static_cast<int>(j);
      for (int column = 0; column < columns_; ++column) {
        const auto [cell, share] = in_cell(column, grid.columns);
        on_rows_[j * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column)] =
            share == 0 ? given(cell, row)
                       : between(given(cell - 1, row), given(cell, row), given(cell + 1, row),
                                 given(cell + 2, row), share);
      }
    });
    on_all_cores(static_cast<std::size_t>(rows_), [&](std::size_t j) {
      const auto [cell, share] = in_cell(static_cast<int>(j), grid.rows);
      for (int column = 0; column < grid.columns; ++column)
        on_columns_[j * static_cast<std::size_t>(grid.columns) + static_cast<std::size_t>(column)] =
            share == 0 ? given(column, cell)
                       : between(given(column, cell - 1), given(column, cell),
                                 given(column, cell + 1), given(column, cell + 2), share);
    });
  }

  std::vector<Height> heights() const {
    std::vector<Height> out(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
    on_all_cores(static_cast<std::size_t>(rows_), [&](std::size_t j) {
      for (int column = 0; column < columns_; ++column)
        out[j * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column)] =
            static_cast<Height>(height(column, static_cast<int>(j)));
    });
    return out;
  }

private:
  struct InCell {
    int cell;
    double share;
  };
  InCell in_cell(int at, int vertices) const {
    const int cell = std::min(at / parts_, vertices - 1);
    return {cell, static_cast<double>(at - cell * parts_) / parts_};
  }

  // NaN outside.
  double given(int column, int row) const {
    if (column < 0 || row < 0 || column >= grid_.columns || row >= grid_.rows) return kNone;
    return heights_[grid_.index(column, row)];
  }
  double on_row(int column, int row) const {
    if (row < 0 || row >= grid_.rows) return kNone;
    return on_rows_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                    static_cast<std::size_t>(column)];
  }
  double on_column(int column, int row) const {
    if (column < 0 || column >= grid_.columns) return kNone;
    return on_columns_[static_cast<std::size_t>(row) * static_cast<std::size_t>(grid_.columns) +
                       static_cast<std::size_t>(column)];
  }

  double height(int column, int row) const {
    const auto [i, x] = in_cell(column, grid_.columns);
    const auto [j, y] = in_cell(row, grid_.rows);
    if (y == 0) return on_row(column, j);
    if (x == 0) return on_column(i, row);
    const Corners at{given(i, j), given(i + 1, j), given(i, j + 1), given(i + 1, j + 1)};
    const bool has_upper = !std::isnan(at.west_north + at.east_north + at.east_south),
               has_lower = !std::isnan(at.west_north + at.west_south + at.east_south);
    if (has_upper && has_lower) return within_cell(at, column, row);
    // The sum of what its two sides on the lattice rise from their common corner.
    if (has_upper && x >= y)
      return within(at.west_north, at.east_north, at.east_south,
                    on_row(column, j) + on_column(i + 1, row) - at.east_north);
    if (has_lower && x <= y)
      return within(at.west_north, at.west_south, at.east_south,
                    on_row(column, j + 1) + on_column(i, row) - at.west_south);
    return kNone;
  }

  static double within(double a, double b, double c, double height) {
    return std::clamp(height, std::min({a, b, c}), std::max({a, b, c}));
  }

  // Rows first, columns first, and what is between: no direction is preferred.
  double within_cell(const Corners& at, int column, int row) const {
    const auto [i, x] = in_cell(column, grid_.columns);
    const auto [j, y] = in_cell(row, grid_.rows);
    const double by_rows = between(on_row(column, j - 1), on_row(column, j), on_row(column, j + 1),
                                   on_row(column, j + 2), y);
    const double by_columns = between(on_column(i - 1, row), on_column(i, row),
                                      on_column(i + 1, row), on_column(i + 2, row), x);
    const double height = by_rows + 0.5 * (by_columns - by_rows);
    const double level = at.west_north;
    if (at.east_south != level) return height;
    if (at.east_north == level && at.west_south != level)
      return x >= y ? level : level + share_of_rise(y - x, 1 - y, x) * (height - level);
    if (at.west_south == level && at.east_north != level)
      return x <= y ? level : level + share_of_rise(x - y, 1 - x, y) * (height - level);
    return height;
  }

  const Grid& grid_;
  const Heights<Height>& heights_;
  int parts_, columns_, rows_;
  std::vector<double> on_rows_, on_columns_; ///< of the new columns, and of the new rows
};

} // namespace

Grid refined(const Grid& grid, int parts) {
  const int columns = (grid.columns - 1) * parts + 1, rows = (grid.rows - 1) * parts + 1;
  Grid out{columns, rows, stretched_lattice(grid, columns, rows), {}};
  std::visit(
      [&]<class Height>(const Heights<Height>& heights) {
        out.heights_m = Heights<Height>(Refiner<Height>(grid, heights, parts).heights());
      },
      grid.heights_m);
  return out;
}

} // namespace orograph
