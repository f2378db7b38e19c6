// SPDX-License-Identifier: GPL-3.0-or-later
// A level that is made of bands of rows is the level that is made of all of them.
#include "dem/levels/departure.hpp"
#include "dem/levels/generalise.hpp"
#include "dem/levels/level_in_bands.hpp"
#include "dem/levels/summits.hpp"
#include "tests/catch.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace orograph::level_in_bands_test {
namespace {

// Hills, with terraces, where neighbours are as high, and voids.
template <class Height>
std::vector<Height> random_heights(Random& random, int columns, int rows) {
  std::vector<Height> heights;
  const double voids = random.chance(0.5) ? 0.03 : 0, terrace = random.pick({0.0, 5.0, 40.0});
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      double height = 100 * std::sin(column * 0.13) * std::cos(row * 0.11) + random.between(-3, 3);
      if (terrace > 0) height = terrace * std::round(height / terrace);
      heights.push_back(static_cast<Height>(
          random.chance(voids) ? std::numeric_limits<double>::quiet_NaN() : height));
    }
  return heights;
}

// As high as the eight around it, as far as these are there.
bool is_level(const Grid& grid, int column, int row) {
  for (int r = row - 1; r <= row + 1; ++r)
    for (int c = column - 1; c <= column + 1; ++c)
      if (c >= 0 && r >= 0 && c < grid.columns && r < grid.rows &&
          std::abs(grid.height_m(c, r) - grid.height_m(column, row)) > 0)
        return false;
  return true;
}

template <class Height>
bool have_same_bits(const std::vector<Height>& a, const Heights<Height>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Height)) == 0;
}

template <class Height>
void check_bands(Random& random) {
  const int columns = random.whole(4, 150), rows = random.whole(4, 150),
            step = 1 << random.whole(1, 5);
  const std::vector<Height> heights = random_heights<Height>(random, columns, rows);
  const Grid grid{columns, rows, PlaneLattice{{}, {3, 0}, {0, -4}}, Heights<Height>(heights)};

  LevelInBands<Height> level(columns, rows, step);
  for (int first = 0; first < rows;) {
    const int count = std::min(random.whole(1, random.pick({3, 40, 150})), rows - first);
    const auto begin = heights.begin() + static_cast<std::ptrdiff_t>(first) * columns;
    level.take({first, count,
                std::make_shared<const std::vector<Height>>(
                    begin, begin + static_cast<std::ptrdiff_t>(count) * columns)});
    first += count;
  }

  const Grid whole =
      generalised(grid, step, [&](int column, int row) { return is_level(grid, column, row); });
  REQUIRE(level.columns() == whole.columns);
  REQUIRE(level.rows() == whole.rows);
  CHECK(have_same_bits(level.heights(), std::get<Heights<Height>>(whole.heights_m)));
  const LargerCells cells = level.larger_cells(10);
  const Departure departure = departure_of(whole, grid);
  CHECK(cells.departure.greatest_m == departure.greatest_m);
  CHECK(cells.departure.rms_m == departure.rms_m);
  CHECK(cells.tops == tops_of(grid, kSummitsApart * step, 10));
  CHECK(cells.step == step);
  CHECK(cells.columns == columns);
  CHECK(cells.rows == rows);
}

} // namespace

TEST_CASE("a level made in bands, however they are cut, is that of the whole grid to the bit") {
  for (std::uint64_t seed = 1; seed <= last_seed(150); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    if (random.chance(0.7))
      check_bands<float>(random);
    else
      check_bands<double>(random);
  }
}

TEST_CASE("summits of a raster in larger cells are where the raster has them") {
  constexpr int kSide = 97;
  std::vector<float> heights(kSide * kSide, 0.F);
  heights[40 * kSide + 33] = 500;
  LevelInBands<float> level(kSide, kSide, 4);
  level.take({0, kSide, std::make_shared<const std::vector<float>>(heights)});
  const LargerCells cells = level.larger_cells(1);
  REQUIRE(cells.tops.size() == 1);
  const Grid made{level.columns(), level.rows(), PlaneLattice{{0, 0}, {40, 0}, {0, -40}},
                  Heights<float>(level.heights())};
  const auto summits = summits_of(cells, made);
  REQUIRE(summits.size() == 1);
  CHECK(summits[0].of_file_m == Vec3{330, -400, 500});
  CHECK(summits[0].drawn_m == Vec3{320, -400, 500}); // the nearest vertex, as high
}

} // namespace orograph::level_in_bands_test
