// SPDX-License-Identifier: GPL-3.0-or-later
// The height of a vertex of a level, and what is highest on a grid, by their definitions.
#include "dem/levels/ground_around.hpp"
#include "dem/levels/tops.hpp"
#include "tests/catch.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>

namespace orograph::ground_around_test {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

// Rows of vertices, some of them voids; of few heights, so that neighbours are often as high.
std::vector<AroundRow> random_rows(Random& random) {
  const auto columns = static_cast<std::size_t>(random.whole(2, 12));
  const int heights = random.pick({2, 6, 1000});
  const double voids = random.pick({0.0, 0.2});
  std::vector<AroundRow> rows(static_cast<std::size_t>(random.whole(2, 6)));
  for (AroundRow& row : rows) {
    const std::vector<double> none(columns + 2, kNone);
    row = {none, none, none};
    for (std::size_t i = 1; i <= columns; ++i) {
      if (random.chance(voids)) continue;
      row.lowest[i] = random.whole(0, heights);
      row.mean[i] = row.lowest[i] + 0.1 * random.whole(0, heights);
      row.highest[i] = row.mean[i] + 0.1 * random.whole(0, heights);
    }
  }
  return rows;
}

// At a place in rows of vertices and beyond them.
double at(const std::vector<AroundRow>& rows, std::vector<double> AroundRow::*what, int column,
          int row) {
  const bool is_in = row >= 0 && row < static_cast<int>(rows.size());
  return is_in ? (rows[static_cast<std::size_t>(row)].*what)[static_cast<std::size_t>(column) + 1]
               : kNone;
}

double defined_height(const std::vector<AroundRow>& rows, int column, int row) {
  const double mean = at(rows, &AroundRow::mean, column, row),
               low = at(rows, &AroundRow::lowest, column, row),
               high = at(rows, &AroundRow::highest, column, row);
  double bend = 0;
  int ways = 0;
  bool is_summit = true;
  for (const auto& [across, down] : {std::pair{1, 0}, {0, 1}, {1, 1}, {-1, 1}}) {
    const double before = at(rows, &AroundRow::mean, column - across, row - down),
                 behind = at(rows, &AroundRow::mean, column + across, row + down);
    if (before >= mean || behind > mean ||
        at(rows, &AroundRow::highest, column - across, row - down) > high ||
        at(rows, &AroundRow::highest, column + across, row + down) > high)
      is_summit = false;
    if (std::isnan(before) || std::isnan(behind)) continue;
    bend += mean - 0.5 * (before + behind);
    ++ways;
  }
  if (!(high > low) || ways == 0) return mean;
  if (is_summit) return high;
  // None up to 0.15 of the relief, four fifths of the way from half of it on.
  const double ridge = std::abs(bend) / ways / (high - low);
  const double share = 0.8 * std::clamp((ridge - 0.15) / 0.35, 0.0, 1.0);
  return mean + share * ((bend > 0 ? high : low) - mean);
}

// The highest vertex of each square, the first of equals in rows; of them those that none beside is
// higher than and that are apart from all higher ones.
std::vector<Top> defined_tops(const Grid& grid, int side, std::size_t most) {
  std::vector<Top> squares, tops;
  for (int first_row = 0; first_row < grid.rows; first_row += side)
    for (int first_column = 0; first_column < grid.columns; first_column += side) {
      std::optional<Top> highest;
      for (int row = first_row; row < std::min(first_row + side, grid.rows); ++row)
        for (int column = first_column; column < std::min(first_column + side, grid.columns);
             ++column)
          if (const double height = grid.height_m(column, row);
              !std::isnan(height) && (!highest || height > highest->height_m))
            highest = Top{height, column, row};
      if (highest) squares.push_back(*highest);
    }
  std::ranges::sort(squares, {},
                    [](const Top& top) { return std::tuple(-top.height_m, top.row, top.column); });
  for (auto top = squares.begin(); top != squares.end() && tops.size() < most; ++top) {
    bool is_top = std::none_of(squares.begin(), top, [&](const Top& higher) {
      return std::abs(higher.column - top->column) < side && std::abs(higher.row - top->row) < side;
    });
    for (int row = std::max(top->row - 1, 0); row <= std::min(top->row + 1, grid.rows - 1); ++row)
      for (int column = std::max(top->column - 1, 0);
           column <= std::min(top->column + 1, grid.columns - 1); ++column)
        is_top = is_top && !(grid.height_m(column, row) > top->height_m);
    if (is_top) tops.push_back(*top);
  }
  return tops;
}

} // namespace

TEST_CASE("the heights of a row of a level are those that ridges, floors and summits ask for") {
  int summits = 0, ridges = 0, means = 0;
  for (std::uint64_t seed = 1; seed <= last_seed(3000); ++seed) {
    Random random(seed);
    const std::vector<AroundRow> rows = random_rows(random);
    const int row = random.whole(0, static_cast<int>(rows.size()) - 1);
    const std::vector<double> heights = heights_with_character(rows, static_cast<std::size_t>(row));
    REQUIRE(heights.size() + 2 == rows[0].mean.size());
    INFO("seed " << seed);
    for (std::size_t i = 0; i < heights.size(); ++i) {
      const double there = defined_height(rows, static_cast<int>(i), row),
                   mean = rows[static_cast<std::size_t>(row)].mean[i + 1],
                   high = rows[static_cast<std::size_t>(row)].highest[i + 1];
      INFO("column " << i << ": " << heights[i] << " and not " << there);
      // Heights are up to 1200; a bend is divided here in another order.
      CHECK((std::isnan(there) ? std::isnan(heights[i]) : std::abs(heights[i] - there) < 1e-9));
      ++(there == mean ? means : there == high ? summits : ridges);
    }
  }
  CHECK(summits > enough(1000));
  CHECK(ridges > enough(1000));
  CHECK(means > enough(1000));
}

TEST_CASE("the tops of a grid are the highest vertices of squares that nothing near is above") {
  std::size_t found = 0;
  for (std::uint64_t seed = 1; seed <= last_seed(300); ++seed) {
    Random random(seed);
    const int columns = random.whole(2, 60), rows = random.whole(2, 60), side = random.whole(1, 20);
    const int heights = random.pick({3, 40, 100000});
    const double voids = random.pick({0.0, 0.1, 0.95});
    std::vector<float> values(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
    for (float& value : values)
      value = static_cast<float>(random.chance(voids) ? kNone : random.whole(-heights, heights));
    const Grid grid{columns, rows, PlaneLattice{{}, {3, 0}, {0, -4}},
                    Heights<float>(std::move(values))};
    INFO("seed " << seed);
    const auto tops = tops_of(grid, side, 10);
    CHECK(tops == defined_tops(grid, side, 10));
    found += tops.size();
  }
  CHECK(found > enough(500));
}

} // namespace orograph::ground_around_test
