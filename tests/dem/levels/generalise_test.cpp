// SPDX-License-Identifier: GPL-3.0-or-later
// A grid's terrain in larger cells: what stays, and how far the rest may go.
#include "dem/height_at.hpp"
#include "dem/levels/departure.hpp"
#include "dem/levels/generalise.hpp"
#include "dem/levels/summits.hpp"
#include "tests/catch.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace orograph::generalise_test {
namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

const auto kKeepsNone = [](int, int) { return false; };

Grid grid_of(int columns, int rows, const std::function<double(int, int)>& height) {
  std::vector<float> heights;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column)
      heights.push_back(static_cast<float>(height(column, row)));
  return {columns, rows, PlaneLattice{{100, 900}, {3, 0}, {0, -4}},
          Heights<float>(std::move(heights))};
}

Grid random_grid(Random& random, double voids) {
  return grid_of(random.whole(20, 90), random.whole(20, 90), [&](int column, int row) {
    if (random.chance(voids)) return static_cast<double>(kNone);
    return 100 * std::sin(column * 0.13) * std::cos(row * 0.11) + random.between(-8, 8);
  });
}

// Of the file, in columns and rows, for a vertex of a level.
double in_file(int at, int of_level, int of_file) {
  return at * (of_file - 1.0) / (of_level - 1);
}

} // namespace

TEST_CASE("a level has the grid's corners, and its number of cells is the next to the step's") {
  for (std::uint64_t seed = 1; seed <= last_seed(200); ++seed) {
    Random random(seed);
    const Grid grid = random_grid(random, 0);
    const int step = random.whole(2, 8);
    const Grid level = generalised(grid, step, kKeepsNone);
    INFO("seed " << seed);
    CHECK(std::abs((level.columns - 1) * step - (grid.columns - 1)) <= 0.5 * step);
    CHECK(std::abs((level.rows - 1) * step - (grid.rows - 1)) <= 0.5 * step);
    const Vec2 file = grid.plane().position_m(grid.columns - 1, grid.rows - 1),
               made = level.plane().position_m(level.columns - 1, level.rows - 1);
    CHECK(length(file - made) < 1e-9);
    CHECK(level.plane().position_m(0, 0) == grid.plane().position_m(0, 0));
  }
}

TEST_CASE("a level is never above what is around in the file, or below it, and has its voids") {
  std::size_t voids = 0, heights = 0;
  for (std::uint64_t seed = 1; seed <= last_seed(200); ++seed) {
    Random random(seed);
    const Grid grid = random_grid(random, 0.1);
    const int step = random.whole(2, 8);
    const Grid level = generalised(grid, step, kKeepsNone);
    INFO("seed " << seed);
    bool have_voids = true, is_between = true;
    for (int row = 0; row < level.rows; ++row)
      for (int column = 0; column < level.columns; ++column) {
        const double x = in_file(column, level.columns, grid.columns),
                     y = in_file(row, level.rows, grid.rows), height = level.height_m(column, row);
        const bool is_void = std::isnan(
            grid.height_m(static_cast<int>(std::lround(x)), static_cast<int>(std::lround(y))));
        have_voids &= std::isnan(height) == is_void;
        ++(is_void ? voids : heights);
        double low = 1e9, high = -1e9;
        for (int r = 0; r < grid.rows; ++r)
          for (int c = 0; c < grid.columns; ++c)
            if (const double there = grid.height_m(c, r); std::abs(r - y) < 1.5 * step &&
                                                          std::abs(c - x) < 1.5 * step &&
                                                          !std::isnan(there)) {
              low = std::min(low, there);
              high = std::max(high, there);
            }
        is_between &= is_void || (height >= low - 1e-4 && height <= high + 1e-4); // floats of 100
      }
    CHECK(have_voids);
    CHECK(is_between);
  }
  CHECK(voids > enough(500));
  CHECK(heights > 10 * voids / 2);
}

TEST_CASE("a slope stays as it is, borders included") {
  for (const int step : {2, 3, 4, 8}) {
    const Grid grid = grid_of(97, 49, [](int column, int row) { return 5 * column - 3 * row; });
    const Grid level = generalised(grid, step, kKeepsNone);
    const Departure departure = departure_of(level, grid);
    INFO("step " << step);
    CHECK(departure.greatest_m < (48 % step == 0 ? 1e-4 : 0.5)); // stretched cells are off a little
  }
}

TEST_CASE("a ridge, a valley floor and summits keep their heights better than a mean does") {
  // Straight, 45 degrees steep, along every direction of the lattice.
  const auto across = [](int column, int row, int way) {
    return way == 0 ? column - 48. : way == 1 ? row - 48. : (column + row - 96) / std::sqrt(2.0);
  };
  for (const int way : {0, 1, 2})
    for (const double sign : {-1.0, 1.0}) {
      const Grid grid = grid_of(97, 97, [&](int column, int row) {
        return sign * (100 - std::abs(across(column, row, way)));
      });
      const Grid level = generalised(grid, 4, kKeepsNone);
      INFO("way " << way << ", sign " << sign);
      for (int i = 4; i < 20; ++i) {
        const double there = way == 0   ? level.height_m(12, i)
                             : way == 1 ? level.height_m(i, 12)
                                        : level.height_m(i, 24 - i);
        CHECK(std::abs(sign * 100 - there) < 0.5); // of a mean 4/3
      }
    }
  const Grid cone =
      grid_of(97, 97, [](int column, int row) { return 100 - std::hypot(column - 50, row - 47); });
  const Grid level = generalised(cone, 4, kKeepsNone);
  const std::vector<Summit> summits = summits_of(cone, level, 10);
  REQUIRE(!summits.empty());
  CHECK(summits.front().of_file_m.z == 100);
  CHECK(summits.front().drawn_m.z == 100);
}

TEST_CASE("what is kept has its own height") {
  const Grid grid = grid_of(65, 65, [](int column, int row) {
    return column < 30 ? 7 : 7 + 2 * (column - 29) + row % 3;
  });
  const Grid level = generalised(grid, 4, [](int column, int) { return column < 30; });
  for (int row = 0; row < level.rows; ++row) {
    for (int column = 0; column <= 7; ++column) CHECK(level.height_m(column, row) == 7);
    CHECK(level.height_m(8, row) > 7);
  }
}

TEST_CASE("departure is what the triangles' own heights say") {
  for (std::uint64_t seed = 1; seed <= last_seed(60); ++seed) {
    Random random(seed);
    const Grid grid = random_grid(random, 0.05);
    const Grid level = generalised(grid, random.whole(2, 5), kKeepsNone);
    double greatest = 0, squares = 0;
    std::size_t count = 0;
    for (int row = 0; row < grid.rows; ++row)
      for (int column = 0; column < grid.columns; ++column) {
        const Vec3 vertex = grid.vertex_m(column, row);
        const auto drawn = height_at(level, {vertex.x, vertex.y});
        if (!drawn || std::isnan(vertex.z)) continue;
        greatest = std::max(greatest, std::abs(*drawn - vertex.z));
        squares += (*drawn - vertex.z) * (*drawn - vertex.z);
        ++count;
      }
    const Departure departure = departure_of(level, grid);
    INFO("seed " << seed);
    REQUIRE(count > 0);
    // At a void's edge, a place of the border may be in or out by rounding.
    CHECK(departure.greatest_m >= greatest - 1e-6);
    CHECK(std::abs(departure.rms_m - std::sqrt(squares / static_cast<double>(count))) <
          0.02 * departure.rms_m);
  }
}

} // namespace orograph::generalise_test
