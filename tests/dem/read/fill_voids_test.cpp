// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/read/raster_heights.hpp"
#include "tests/catch.hpp"
#include "tests/support/random.hpp"

#include <gdal_priv.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace orograph::fill_voids_test {
namespace {

template <class Height>
void check_fill(std::uint64_t seed) {
  GDALAllRegister();
  Random random(seed);
  INFO("seed " << seed);
  Grid grid;
  grid.columns = random.whole(2, 30);
  grid.rows = random.whole(2, 30);
  std::vector<Height> before(grid.size());
  const double share = random.pick({0.02, 0.3, 0.9});
  for (Height& h : before)
    h = random.chance(share) ? std::numeric_limits<Height>::quiet_NaN()
                             : static_cast<Height>(random.between(100, 200));
  grid.heights_m = before;
  const double cells = random.pick({1.0, 3.0, 100.0});
  const FilledVoids voids = fill_voids(grid, cells);
  const auto& after = std::get<Heights<Height>>(grid.heights_m);
  std::size_t missing = 0, filled = 0;
  Height low = 1e9, high = -1e9;
  for (const Height h : before)
    if (!std::isnan(h)) {
      low = std::min(low, h);
      high = std::max(high, h);
    }
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (!std::isnan(before[i])) {
      REQUIRE(std::memcmp(&before[i], &after[i], sizeof(Height)) == 0);
      continue;
    }
    ++missing;
    const int column = static_cast<int>(i) % grid.columns, row = static_cast<int>(i) / grid.columns;
    double nearest = HUGE_VAL; // known height
    for (int r = 0; r < grid.rows; ++r)
      for (int c = 0; c < grid.columns; ++c)
        if (!std::isnan(before[grid.index(c, r)]))
          nearest = std::min(nearest, std::hypot(c - column, r - row));
    CAPTURE(column, row, nearest, cells);
    if (std::isnan(after[i])) continue;
    ++filled;
    REQUIRE(nearest <= cells + 1e-6);
    REQUIRE(after[i] >= low - 1e-3);
    REQUIRE(after[i] <= high + 1e-3);
  }
  REQUIRE(voids.filled == filled);
  REQUIRE(voids.left == missing - filled);
  if (cells == 1 && share == 0.02) return;
  if (cells == 100 && missing < before.size()) REQUIRE(voids.left == 0);
}

} // namespace

TEST_CASE("voids are filled from near heights, and heights that are there stay to the bit") {
  for (std::uint64_t seed = 1; seed <= last_seed(200); ++seed) {
    check_fill<float>(seed);
    check_fill<double>(seed + 1000);
  }
}

TEST_CASE("a hole in a plateau is filled level, and nothing but holes stays as it is") {
  GDALAllRegister();
  Grid grid;
  grid.columns = grid.rows = 9;
  std::vector<double> heights(grid.size(), 850.25);
  for (int r = 3; r < 6; ++r)
    for (int c = 2; c < 7; ++c) heights[grid.index(c, r)] = std::nan("");
  grid.heights_m = heights;
  const FilledVoids voids = fill_voids(grid, 10);
  CHECK(voids.filled == 15);
  CHECK(voids.left == 0);
  for (const double h : std::get<Heights<double>>(grid.heights_m))
    CHECK(h == Approx(850.25).epsilon(1e-7));

  grid.heights_m = std::vector<double>(grid.size(), std::nan(""));
  CHECK(fill_voids(grid, 10).left == grid.size());
  grid.heights_m = std::vector<double>(grid.size(), 1.0);
  CHECK(fill_voids(grid, 10).filled == 0);
}

} // namespace orograph::fill_voids_test
