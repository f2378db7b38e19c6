// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/levels/summits.hpp"

#include "geometry/on_all_cores.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

namespace orograph {
namespace {

constexpr int kApart = 16; // of the larger cells

struct Highest {
  double height_m;
  int column, row;
};

// Of each square of so many vertices on a side.
std::vector<Highest> highest_of_squares(const Grid& grid, int side) {
  const auto across = static_cast<std::size_t>((grid.columns + side - 1) / side),
             down = static_cast<std::size_t>((grid.rows + side - 1) / side);
  std::vector<Highest> squares(across * down, {-std::numeric_limits<double>::infinity(), 0, 0});
  std::visit(
      [&](const auto& heights) {
        on_all_cores(down, [&](std::size_t band) {
          const int first = static_cast<int>(band) * side, end = std::min(first + side, grid.rows);
          for (int row = first; row < end; ++row)
            for (int column = 0; column < grid.columns; ++column) {
              Highest& highest = squares[band * across + static_cast<std::size_t>(column / side)];
              const double height = heights[grid.index(column, row)];
              if (height > highest.height_m) highest = {height, column, row};
            }
        });
      },
      grid.heights_m);
  return squares;
}

// None beside it is higher.
bool is_top(const Grid& grid, const Highest& highest) {
  for (int row = std::max(0, highest.row - 1); row <= std::min(grid.rows - 1, highest.row + 1);
       ++row)
    for (int column = std::max(0, highest.column - 1);
         column <= std::min(grid.columns - 1, highest.column + 1); ++column)
      if (grid.height_m(column, row) > highest.height_m) return false;
  return true;
}

// Of squares of so many vertices on a side, from the highest on; at most so many.
std::vector<Highest> tops_of(const Grid& grid, int side, std::size_t most) {
  std::vector<Highest> squares = highest_of_squares(grid, side);
  std::sort(squares.begin(), squares.end(), [](const Highest& a, const Highest& b) {
    return a.height_m != b.height_m ? a.height_m > b.height_m
           : a.row != b.row         ? a.row < b.row
                                    : a.column < b.column;
  });
  std::vector<Highest> tops, taken;
  for (const Highest& highest : squares) {
    if (tops.size() == most || !std::isfinite(highest.height_m)) break;
    const bool is_apart = std::none_of(taken.begin(), taken.end(), [&](const Highest& other) {
      return std::abs(other.column - highest.column) < side &&
             std::abs(other.row - highest.row) < side;
    });
    // The highest of its square may stand on a slope that goes on rising in the next one.
    taken.push_back(highest);
    if (is_apart && is_top(grid, highest)) tops.push_back(highest);
  }
  return tops;
}

} // namespace

std::vector<Summit> summits_of(const Grid& grid, const Grid& level, std::size_t most) {
  const double per_column = (level.columns - 1.0) / (grid.columns - 1),
               per_row = (level.rows - 1.0) / (grid.rows - 1);
  const int side =
      std::max(1, static_cast<int>(kApart / std::min(1.0, std::max(per_column, per_row))));
  std::vector<Summit> summits;
  // One of which no height is drawn takes no other's place.
  for (const Highest& highest : tops_of(grid, side, most)) {
    Summit summit{grid.vertex_m(highest.column, highest.row), {}};
    double drawn_m = -std::numeric_limits<double>::infinity();
    const auto column = static_cast<int>(std::lround(highest.column * per_column)),
               row = static_cast<int>(std::lround(highest.row * per_row));
    if (const double height = level.height_m(column, row); !std::isnan(height)) {
      drawn_m = height; // before those beside that are as high
      summit.drawn_m = level.vertex_m(column, row);
    }
    for (int r = std::max(0, row - 1); r <= std::min(level.rows - 1, row + 1); ++r)
      for (int c = std::max(0, column - 1); c <= std::min(level.columns - 1, column + 1); ++c)
        if (const double height = level.height_m(c, r); height > drawn_m) {
          drawn_m = height;
          summit.drawn_m = level.vertex_m(c, r);
        }
    if (std::isfinite(drawn_m)) summits.push_back(summit);
  }
  return summits;
}

std::vector<Summit> summits_of(const Grid& grid, const Patchwork& made, const Patches& patches,
                               std::size_t most) {
  std::vector<Summit> summits;
  for (const Highest& highest : tops_of(grid, kApart, most)) {
    const std::int64_t file = patches.cell(0);
    const std::int64_t column = highest.column * file, row = highest.row * file;
    const std::int64_t reach = patches.cell(patches.coarsest_at(column, row));
    const auto count = static_cast<std::ptrdiff_t>(made.places.size());
    std::ptrdiff_t best = -1;
    for (std::ptrdiff_t i = 0; i < count; ++i) {
      const auto& [c, r] = made.places[static_cast<std::size_t>(i)];
      if (std::abs(c - column) > reach || std::abs(r - row) > reach) continue;
      const double height_m = made.heights_m[static_cast<std::size_t>(i)];
      if (best < 0 || height_m > made.heights_m[static_cast<std::size_t>(best)] ||
          (height_m == made.heights_m[static_cast<std::size_t>(best)] && c == column && r == row))
        best = i;
    }
    if (best >= 0)
      summits.push_back({grid.vertex_m(highest.column, highest.row),
                         made.tin.vertices_m[static_cast<std::size_t>(best)]});
  }
  return summits;
}

} // namespace orograph
