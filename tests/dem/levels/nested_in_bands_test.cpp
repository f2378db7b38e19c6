// SPDX-License-Identifier: GPL-3.0-or-later
// Nested levels that are made of bands of rows, against all heights of the grid, one by one.
#include "dem/levels/nested_in_bands.hpp"
#include "tests/catch.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

namespace orograph::nested_in_bands_test {
namespace {

template <class Height>
struct Made {
  int columns, rows;
  std::vector<Height> heights;

  double at(int column, int row) const {
    return heights[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                   static_cast<std::size_t>(column)];
  }
};

template <class Height>
Made<Height> random_grid(Random& random) {
  // Sizes that cells of a level part evenly, and others.
  const auto side = [&] {
    return random.pick(
        {64 * random.whole(1, 9) + 1, random.whole(20, 600), 1025 + random.whole(0, 60)});
  };
  Made<Height> out{side(), random.whole(20, 300), {}};
  if (random.chance(0.4)) out.rows = 64 * random.whole(1, 4) + random.whole(0, 2);
  const int voids = random.pick({0, 1, 40});
  for (int row = 0; row < out.rows; ++row)
    for (int column = 0; column < out.columns; ++column)
      out.heights.push_back(static_cast<Height>(
          90 * std::sin(column * 0.03) * std::cos(row * 0.05) + random.between(-2, 2)));
  // Often on patches' borders, of which some other one begins there.
  const auto place = [&](int vertices) {
    const int at = random.whole(0, vertices - 1);
    return random.chance(0.5) ? at / 32 * 32 : at;
  };
  for (int i = 0; i < voids; ++i) {
    const auto row = static_cast<std::size_t>(place(out.rows)),
               column = static_cast<std::size_t>(place(out.columns));
    out.heights[row * static_cast<std::size_t>(out.columns) + column] =
        std::numeric_limits<Height>::quiet_NaN();
  }
  return out;
}

// By barycentric shares of the triangle that has the place, of a cell from north-west to
// south-east.
template <class Height>
double on_triangle(const Made<Height>& grid, int column, int row, int step, double x, double y) {
  const auto corner = [&](int across, int down) {
    return grid.at(column + across * step, row + down * step);
  };
  const double third = x > y ? corner(1, 0) : corner(0, 1), of_third = std::abs(x - y);
  return corner(0, 0) * (1 - std::max(x, y)) + corner(1, 1) * std::min(x, y) + third * of_third;
}

template <class Height>
void check_patch(const Made<Height>& grid, const NestedCells& cells, int level, int column,
                 int row) {
  const int step = 1 << level, side = kPatchCells * step, west = column * side, north = row * side,
            east = std::min(west + side, grid.columns - 1),
            south = std::min(north + side, grid.rows - 1);
  const Departure told = cells.departure(level, column, row);
  bool is_whole = (east - west) % step == 0 && (south - north) % step == 0;
  double greatest = 0, squares = 0;
  for (int r = north; is_whole && r <= south; ++r)
    for (int c = west; c <= east; ++c) {
      const int of_column = std::min((c - west) / step * step + west, east - step),
                of_row = std::min((r - north) / step * step + north, south - step);
      const double apart =
          on_triangle(grid, of_column, of_row, step, static_cast<double>(c - of_column) / step,
                      static_cast<double>(r - of_row) / step) -
          grid.at(c, r);
      if (std::isnan(apart) || std::isnan(grid.at(c, r))) is_whole = false;
      greatest = std::max(greatest, std::abs(apart));
      if (c < east && r < south) squares += apart * apart;
    }
  if (!is_whole) {
    CHECK(std::isinf(told.greatest_m));
    return;
  }
  CHECK(std::abs(told.greatest_m - greatest) < 1e-9);
  CHECK(std::abs(told.rms_m - std::sqrt(squares / (east - west) / (south - north))) < 1e-9);
}

template <class Height>
void check_grid(Random& random, std::size_t& whole) {
  const Made<Height> grid = random_grid<Height>(random);
  NestedInBands<Height> nested(grid.columns, grid.rows);
  for (int first = 0; first < grid.rows;) {
    const int count = std::min(random.whole(1, random.pick({3, 70, 300})), grid.rows - first);
    const auto begin = grid.heights.begin() + static_cast<std::ptrdiff_t>(first) * grid.columns;
    nested.take({first, count,
                 std::make_shared<const std::vector<Height>>(
                     begin, begin + static_cast<std::ptrdiff_t>(count) * grid.columns)});
    first += count;
  }
  const NestedCells cells = nested.move_cells();
  REQUIRE(cells.departures.size() == static_cast<std::size_t>(cells.coarsest));
  for (int level = 1; level <= cells.coarsest; ++level)
    for (int row = 0; row < patches_along(grid.rows, level); ++row)
      for (int column = 0; column < patches_along(grid.columns, level); ++column) {
        check_patch(grid, cells, level, column, row);
        whole += std::isfinite(cells.departure(level, column, row).greatest_m);
      }
  for (int level = kFinestKept; level <= cells.coarsest; ++level) {
    PatchHeights all;
    for (int c = 0; c < grid.columns; c += 1 << level) all.columns.push_back(c);
    for (int r = 0; r < grid.rows; r += 1 << level) all.rows.push_back(r);
    all.heights_m = cells.heights_m(level, all);
    std::size_t wrong = 0;
    for (std::size_t j = 0; j < all.rows.size(); ++j)
      for (std::size_t i = 0; i < all.columns.size(); ++i) {
        const double file =
            grid.at(static_cast<int>(all.columns[i]), static_cast<int>(all.rows[j]));
        wrong += !(all.at(i, j) == file || (std::isnan(file) && std::isnan(all.at(i, j))));
      }
    CHECK(wrong == 0);
  }
  for (int row = 0; row < patches_along(grid.rows, 0); ++row)
    for (int column = 0; column < patches_along(grid.columns, 0); ++column) {
      PartHeights range;
      for (int r = row * kPatchCells; r <= std::min((row + 1) * kPatchCells, grid.rows - 1); ++r)
        for (int c = column * kPatchCells;
             c <= std::min((column + 1) * kPatchCells, grid.columns - 1); ++c)
          if (!std::isnan(grid.at(c, r))) range.include({grid.at(c, r), grid.at(c, r)});
      const PartHeights& told =
          cells.ranges[static_cast<std::size_t>(row * patches_along(grid.columns, 0) + column)];
      CHECK(told.low_m == range.low_m);
      CHECK(told.high_m == range.high_m);
    }
}

} // namespace

TEST_CASE("nested levels made in bands have the grid's heights, and tell how far others are off") {
  std::size_t whole = 0;
  for (std::uint64_t seed = 1; seed <= last_seed(16); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    if (random.chance(0.7))
      check_grid<float>(random, whole);
    else
      check_grid<double>(random, whole);
  }
  CHECK(whole > enough(500));
}

} // namespace orograph::nested_in_bands_test
