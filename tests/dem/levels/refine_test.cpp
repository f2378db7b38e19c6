// SPDX-License-Identifier: GPL-3.0-or-later
// A grid's terrain in smaller cells: what stays, how far the rest may go, and that it is smooth.
#include "dem/levels/refine.hpp"
#include "tests/catch.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace orograph::refine_test {
namespace {

Grid grid_of(int columns, int rows, const std::function<double(int, int)>& height) {
  std::vector<double> heights;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) heights.push_back(height(column, row));
  return {columns, rows, PlaneLattice{{100, 900}, {3, 0}, {0, -4}},
          Heights<double>(std::move(heights))};
}

// Cliffs, level ground, shores and voids beside each other.
Grid rugged_grid(Random& random, int side) {
  const bool is_huge = random.chance(0.1);
  const double voids = random.pick({0.0, 0.02, 0.2});
  return grid_of(side, side, [&](int, int) {
    if (random.chance(voids)) return std::numeric_limits<double>::quiet_NaN();
    return random.pick({0.0, 0.0, 1.0, 2.0, random.between(0, 3), 1000.0, is_huge ? 1e37 : 7.0});
  });
}

bool has_triangle(const Grid& grid, int column, int row, bool upper) {
  const double other = upper ? grid.height_m(column + 1, row) : grid.height_m(column, row + 1);
  return !std::isnan(grid.height_m(column, row) + grid.height_m(column + 1, row + 1) + other);
}

// How much a slope changes from one side of a line of the given grid to the other, at most, along
// rows and columns, at lines of the new grid, per column and row.
double greatest_kink(const Grid& fine, int parts) {
  double greatest = 0;
  for (int row = 2 * parts; row < fine.rows - 2 * parts; ++row)
    for (int column = 2 * parts; column < fine.columns - 2 * parts; ++column) {
      const auto bend = [&](int across, int down) {
        return std::abs(fine.height_m(column - across, row - down) -
                        2 * fine.height_m(column, row) +
                        fine.height_m(column + across, row + down)) *
               parts;
      };
      if (column % parts == 0) greatest = std::max(greatest, bend(1, 0));
      if (row % parts == 0) greatest = std::max(greatest, bend(0, 1));
    }
  return greatest;
}

} // namespace

TEST_CASE("heights stay, with their triangles, and none between leaves its cell's range") {
  std::size_t cells = 0, level = 0, absent = 0;
  constexpr int kSide = 60;
  for (std::uint64_t seed = 1; seed <= last_seed(300); ++seed) {
    Random random(seed);
    const Grid grid = rugged_grid(random, kSide);
    const int parts = random.whole(2, 8);
    const Grid fine = refined(grid, parts);
    INFO("seed " << seed << ", " << parts << " parts");
    REQUIRE(fine.columns == (kSide - 1) * parts + 1);
    bool stay = true, are_there = true, are_between = true, are_level = true;
    for (int row = 0; row < kSide; ++row)
      for (int column = 0; column < kSide; ++column) {
        const double height = grid.height_m(column, row),
                     now = fine.height_m(column * parts, row * parts);
        stay &= height == now || (std::isnan(height) && std::isnan(now));
      }
    for (int row = 0; row + 1 < kSide; ++row)
      for (int column = 0; column + 1 < kSide; ++column)
        for (const bool upper : {false, true}) {
          ++cells;
          const bool has = has_triangle(grid, column, row, upper);
          const double a = grid.height_m(column, row), d = grid.height_m(column + 1, row + 1),
                       b = upper ? grid.height_m(column + 1, row) : grid.height_m(column, row + 1),
                       e = upper ? grid.height_m(column, row + 1) : grid.height_m(column + 1, row);
          double low = std::min({a, b, d}), high = std::max({a, b, d});
          const bool is_level = has && low == high;
          level += is_level ? 1 : 0;
          absent += has ? 0 : 1;
          // What is missing on the other side of the diagonal has no part in it.
          if (!std::isnan(e)) {
            low = std::min(low, e);
            high = std::max(high, e);
          }
          for (int y = 0; y < parts; ++y)
            for (int x = 0; x < parts; ++x)
              for (const bool of_upper : {false, true}) {
                const bool within = of_upper ? (upper && x >= y) || (!upper && x < y)
                                             : (upper && x > y) || (!upper && x <= y);
                if (!within) continue;
                const int c = column * parts + x, r = row * parts + y;
                are_there &= has_triangle(fine, c, r, of_upper) == has;
                if (!has) continue;
                for (const double height :
                     {fine.height_m(c, r), fine.height_m(c + 1, r + 1),
                      of_upper ? fine.height_m(c + 1, r) : fine.height_m(c, r + 1)}) {
                  are_between &= low <= height && height <= high;
                  are_level &= !is_level || height == a;
                }
              }
        }
    CHECK(stay);
    CHECK(are_there);
    CHECK(are_between);
    CHECK(are_level);
  }
  CHECK(cells > enough(1000000));
  CHECK(level > cells / 100);
  CHECK(absent > cells / 20);
}

TEST_CASE("a slope stays as it is, up to the borders and beside voids") {
  for (const int parts : {2, 3, 8}) {
    const auto plane = [](double column, double row) { return 5 * column - 3 * row; };
    const Grid grid = grid_of(20, 30, [&](int column, int row) {
      return column == 11 && row % 7 == 3 ? std::nan("") : plane(column, row);
    });
    const Grid fine = refined(grid, parts);
    double off = 0;
    for (int row = 0; row < fine.rows; ++row)
      for (int column = 0; column < fine.columns; ++column) {
        const double height = fine.height_m(column, row);
        if (std::isnan(height)) continue;
        off = std::max(off, std::abs(height - plane(static_cast<double>(column) / parts,
                                                    static_cast<double>(row) / parts)));
      }
    CHECK(off < 1e-12 * 200);
  }
}

TEST_CASE("slopes go on from cell to cell, and the ground between is nearer than facets") {
  // Rises everywhere, so that no slope is limited.
  const auto rising = [](double x, double y) {
    return 40 * std::exp(0.05 * x) + 25 * std::exp(0.04 * y) + 8 * std::sin(0.2 * x + 0.1 * y);
  };
  const Grid grid = grid_of(30, 30, rising);
  double kink = std::numeric_limits<double>::infinity();
  for (const int parts : {2, 4, 8, 16}) {
    const double now = greatest_kink(refined(grid, parts), parts);
    CHECK(now < 0.6 * kink); // a true kink would stay
    kink = now;
  }
  constexpr int kParts = 4;
  const Grid fine = refined(grid, kParts);
  double facets = 0, smooth = 0;
  for (int row = kParts; row < fine.rows - kParts; ++row)
    for (int column = kParts; column < fine.columns - kParts; ++column) {
      const double x = static_cast<double>(column) / kParts, y = static_cast<double>(row) / kParts;
      const int i = static_cast<int>(x), j = static_cast<int>(y);
      const double u = x - i, v = y - j;
      const double a = rising(i, j), d = rising(i + 1, j + 1);
      const double facet = u > v ? (1 - u) * a + (u - v) * rising(i + 1, j) + v * d
                                 : (1 - v) * a + (v - u) * rising(i, j + 1) + u * d;
      facets = std::max(facets, std::abs(facet - rising(x, y)));
      smooth = std::max(smooth, std::abs(fine.height_m(column, row) - rising(x, y)));
    }
  CHECK(smooth < 0.1 * facets);
}

TEST_CASE("a ground and its mirror image along the diagonal are refined alike") {
  Random random(3);
  const Grid grid = rugged_grid(random, 40);
  const Grid turned =
      grid_of(40, 40, [&](int column, int row) { return grid.height_m(row, column); });
  const Grid fine = refined(grid, 5), other = refined(turned, 5);
  double apart = 0;
  for (int row = 0; row < fine.rows; ++row)
    for (int column = 0; column < fine.columns; ++column) {
      const double height = fine.height_m(column, row), mirrored = other.height_m(row, column);
      REQUIRE(std::isnan(height) == std::isnan(mirrored));
      if (!std::isnan(height))
        apart = std::max(apart, std::abs(height - mirrored) / (1 + std::abs(height)));
    }
  CHECK(apart < 1e-9); // of sums in another order
}

} // namespace orograph::refine_test
