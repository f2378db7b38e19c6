// SPDX-License-Identifier: GPL-3.0-or-later
// How far summits rise above the way to higher ground.
#include "tests/catch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <queue>
#include <random>
#include <vector>

#include "naming/dominance.hpp"
#include "naming/prominence.hpp"

namespace orograph::prominence_test {
namespace {

Grid grid_of_heights(int columns, int rows, const std::vector<float>& heights) {
  return {columns, rows, PlaneLattice{{0, 0}, {10, 0}, {0, -10}}, Heights<float>(heights)};
}

bool is_higher(const std::vector<float>& heights, std::size_t a, std::size_t b) {
  return heights[a] != heights[b] ? heights[a] > heights[b] : a < b;
}

// A flood from the summit itself, the highest shore first, until it is on higher ground, or falls
// below a border.
Prominence flooded(int columns, int rows, const std::vector<float>& heights, std::size_t summit) {
  constexpr int kRound[6][2] = {{1, 0}, {1, 1}, {0, 1}, {-1, 0}, {-1, -1}, {0, -1}};
  const auto lower = [&](std::size_t a, std::size_t b) { return is_higher(heights, b, a); };
  std::priority_queue<std::size_t, std::vector<std::size_t>, decltype(lower)> shore(lower);
  std::vector<bool> known(heights.size());
  shore.push(summit);
  known[summit] = true;
  float lowest = heights[summit];
  bool is_open = false;
  while (!shore.empty()) {
    const std::size_t here = shore.top();
    shore.pop();
    if (is_higher(heights, here, summit)) return {heights[summit] - lowest, false};
    if (is_open && heights[here] < lowest) break;
    lowest = std::min(lowest, heights[here]);
    for (const auto& [right, down] : kRound) {
      const int c = static_cast<int>(here) % columns + right,
                r = static_cast<int>(here) / columns + down;
      const bool inside = c >= 0 && r >= 0 && c < columns && r < rows;
      const auto there = static_cast<std::size_t>(inside ? r * columns + c : 0);
      if (!inside || std::isnan(heights[there])) {
        is_open = true;
      } else if (!known[there]) {
        known[there] = true;
        shore.push(there);
      }
    }
  }
  return {heights[summit] - lowest, true};
}

} // namespace

TEST_CASE("prominences are those of a flood from each summit") {
  std::mt19937 engine(11);
  int exact = 0;
  for (int round = 0; round < 120; ++round) {
    const int columns = 3 + static_cast<int>(engine() % 12),
              rows = 3 + static_cast<int>(engine() % 12);
    std::vector<float> heights(static_cast<std::size_t>(columns * rows));
    const unsigned levels = round % 2 == 0 ? 6 : 100000; // many equal ones, or hardly any
    for (float& height : heights) height = static_cast<float>(engine() % levels);
    if (round % 5 == 0)
      heights[engine() % heights.size()] = std::numeric_limits<float>::quiet_NaN();
    std::vector<std::uint32_t> asked;
    for (std::size_t i = 0; i < heights.size(); ++i)
      if (!std::isnan(heights[i])) asked.push_back(static_cast<std::uint32_t>(i));
    const auto found = prominences(grid_of_heights(columns, rows, heights), asked);
    for (std::size_t i = 0; i < asked.size(); ++i) {
      const Prominence expected = flooded(columns, rows, heights, asked[i]);
      CAPTURE(round, columns, rows, asked[i]);
      CHECK(found[i].m == expected.m);
      // A pass as high as the border's place may be met first.
      if (levels > 6 && expected.m > 0 && expected.is_at_least) CHECK(found[i].is_at_least);
      if (found[i].m > 0 && !found[i].is_at_least) ++exact;
    }
  }
  CHECK(exact > 100);
}

TEST_CASE("a TIN of a grid's triangles has its prominences, and its dominance along edges") {
  std::mt19937 engine(12);
  constexpr int kSide = 12;
  std::vector<float> heights(kSide * kSide);
  for (float& height : heights) height = static_cast<float>(engine() % 1000);
  const Grid grid = grid_of_heights(kSide, kSide, heights);
  Tin tin;
  for (int r = 0; r < kSide; ++r)
    for (int c = 0; c < kSide; ++c) tin.vertices_m.push_back(grid.vertex_m(c, r));
  const auto at = [](int c, int r) { return static_cast<std::uint32_t>(r * kSide + c); };
  for (int r = 0; r + 1 < kSide; ++r)
    for (int c = 0; c + 1 < kSide; ++c) {
      tin.triangles.push_back({at(c, r), at(c, r + 1), at(c + 1, r + 1)});
      tin.triangles.push_back({at(c, r), at(c + 1, r + 1), at(c + 1, r)});
    }
  tin.neighbours.assign(tin.triangles.size(), {kNoTriangle, kNoTriangle, kNoTriangle});
  for (std::uint32_t t = 0; t < tin.triangles.size(); ++t)
    for (std::uint32_t other = 0; other < tin.triangles.size(); ++other)
      for (std::size_t k = 0; k < 3 && other != t; ++k) {
        const auto &mine = tin.triangles[t], &its = tin.triangles[other];
        if (std::ranges::count(its, mine[(k + 1) % 3]) +
                std::ranges::count(its, mine[(k + 2) % 3]) ==
            2)
          tin.neighbours[t][k] = other;
      }
  std::vector<std::uint32_t> all(tin.vertices_m.size());
  std::iota(all.begin(), all.end(), 0U);
  const TinIndex index(tin);
  const auto of_grid = prominences(grid, all), of_tin = prominences(tin, all);
  for (const std::uint32_t i : all) {
    CAPTURE(i);
    CHECK(of_tin[i].m == of_grid[i].m);
    for (const Vec2 along_edges : {Vec2{1, 0}, Vec2{0, 1}})
      CHECK(dominance_m(tin, index, i, along_edges) ==
            Approx(dominance_m(grid, i, along_edges)).margin(1e-9));
  }
}

TEST_CASE("dominance is above the higher of the lows on both sides") {
  // Along a row: a summit of 50, lows of 20 and 10 on its sides, higher ground beyond.
  const Grid grid = grid_of_heights(7, 2, {90, 20, 30, 50, 10, 40, 60, 90, 20, 30, 50, 10, 40, 60});
  CHECK(dominance_m(grid, 3, {1, 0}) == 30);
  CHECK(dominance_m(grid, 3, {-1, 0}) == 30);
  CHECK(dominance_m(grid, 5, {1, 0}) == 0); // the ground rises at once
  CHECK(dominance_m(grid, 0, {1, 0}) == 0); // the terrain ends
}

} // namespace orograph::prominence_test
