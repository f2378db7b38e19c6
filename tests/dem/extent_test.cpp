// SPDX-License-Identifier: GPL-3.0-or-later
// Extents against brute force over all vertices.
#include "dem/extent.hpp"
#include "tests/catch.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace orograph::extent_test {
namespace {

// Heights from a fixed sequence, about `gaps` of them NaN.
template <class Value>
Grid scattered_grid(int columns, int rows, double gaps) {
  Grid grid;
  grid.columns = columns;
  grid.rows = rows;
  grid.plane().first_vertex_m = {-3.7, 12.9};
  grid.plane().column_step_m = {0.3, 0.1};
  grid.plane().row_step_m = {0.07, -0.4};
  std::vector<Value> heights(grid.size());
  std::uint32_t state = 1;
  const auto next = [&state] {
    state = state * 1664525u + 1013904223u;
    return (state >> 8) / 16777216.;
  };
  for (Value& height : heights) {
    const bool gap = next() < gaps;
    const double value = 1000 * next() - 500;
    height = gap ? std::numeric_limits<Value>::quiet_NaN() : static_cast<Value>(value);
  }
  grid.heights_m = std::move(heights);
  return grid;
}

struct Brute {
  Box3 box;
  double sum = 0;
  std::size_t valid = 0;
};

Brute brute_force(const Grid& grid, int first_column, int first_row, int columns, int rows) {
  Brute all;
  for (int row = first_row; row < std::min(first_row + rows, grid.rows); ++row)
    for (int column = first_column; column < std::min(first_column + columns, grid.columns);
         ++column) {
      const double height = grid.height_m(column, row);
      if (std::isnan(height)) continue;
      const Vec2 at = grid.plane().position_m(column, row);
      all.box.include({at.x, at.y, height});
      all.sum += height;
      ++all.valid;
    }
  return all;
}

void check_against_brute_force(const Grid& grid) {
  SurfaceExtent extent = extent_of(grid);
  const Brute all = brute_force(grid, 0, 0, grid.columns, grid.rows);
  CHECK(extent.valid == all.valid);
  CHECK(extent.box.low == all.box.low);
  CHECK(extent.box.high == all.box.high);
  // Another order of adding up to 1e4 heights of up to 500 m.
  CHECK(std::abs(extent.mean_height_m - all.sum / double(all.valid)) <= 1e-9);

  std::size_t block = 0;
  for (int row = 0; row < grid.rows; row += 32)
    for (int column = 0; column < grid.columns; column += 32) {
      const Brute part = brute_force(grid, column, row, 32, 32);
      if (part.valid == 0) continue;
      REQUIRE(block < extent.blocks.boxes.size());
      CHECK(extent.blocks.boxes[block].low == part.box.low);
      CHECK(extent.blocks.boxes[block].high == part.box.high);
      const auto points = extent.blocks.points(block);
      REQUIRE(points.size() == part.valid);
      Brute seen;
      for (const Vec3& point : points) seen.box.include(point);
      CHECK(seen.box.low == part.box.low);
      CHECK(seen.box.high == part.box.high);
      ++block;
    }
  CHECK(block == extent.blocks.boxes.size());
}

// Every block in one group, whose box is just that of its blocks.
void check_groups(const BlockedPoints& blocks) {
  std::vector<int> seen(blocks.boxes.size(), 0);
  for (const BlockGroup& group : blocks.groups) {
    CHECK(!group.blocks.empty());
    CHECK(group.blocks.size() <= 64);
    Box3 box;
    for (const std::uint32_t block : group.blocks) {
      ++seen.at(block);
      box.include(blocks.boxes[block].low);
      box.include(blocks.boxes[block].high);
    }
    CHECK(group.box.low == box.low);
    CHECK(group.box.high == box.high);
  }
  CHECK(std::all_of(seen.begin(), seen.end(), [](int times) { return times == 1; }));
}

} // namespace

TEST_CASE("boxes, mean and points of blocks are those of brute force") {
  for (const double gaps : {0., 0.1, 0.5, 0.9995}) {
    check_against_brute_force(scattered_grid<float>(100, 70, gaps));
    check_against_brute_force(scattered_grid<double>(64, 96, gaps));
  }
  check_against_brute_force(scattered_grid<float>(2, 2, 0));
  check_against_brute_force(scattered_grid<double>(33, 2, 0.3));
}

TEST_CASE("a single valid vertex is the extent") {
  Grid grid = scattered_grid<float>(50, 50, 1);
  const auto heights = std::get<Heights<float>>(grid.heights_m).own();
  heights[grid.index(40, 10)] = -7;
  const SurfaceExtent extent = extent_of(grid);
  CHECK(extent.valid == 1);
  CHECK(extent.mean_height_m == -7);
  CHECK(extent.blocks.boxes.size() == 1);
  CHECK(extent.box.low == extent.box.high);
}

TEST_CASE("points of the last blocks are kept, others use their memory") {
  const Grid grid = scattered_grid<float>(32 * 81, 32, 0);
  const SurfaceExtent extent = extent_of(grid);
  REQUIRE(extent.blocks.boxes.size() == 81);
  const auto is_of = [&](std::size_t block, std::span<const Vec3> points) {
    Box3 box;
    for (const Vec3& point : points) box.include(point);
    return box.low == extent.blocks.boxes[block].low && box.high == extent.blocks.boxes[block].high;
  };
  const Vec3* first = extent.blocks.points(0).data();
  CHECK(extent.blocks.points(0).data() == first);
  for (std::size_t i = 0; i < 81; ++i) CHECK(is_of(i, extent.blocks.points(i)));
  CHECK(extent.blocks.points(64).data() == first);
  CHECK(is_of(0, extent.blocks.points(0)));
}

TEST_CASE("each block is in one group") {
  for (const double gaps : {0., 0.5, 0.9995}) {
    check_against_brute_force(scattered_grid<float>(600, 290, gaps));
    check_groups(extent_of(scattered_grid<float>(600, 290, gaps)).blocks);
  }
  check_groups(extent_of(scattered_grid<double>(257, 2, 0)).blocks);
  Tin tin;
  for (int i = 0; i < 70000; ++i) tin.vertices_m.push_back({1.0 * i, 7.0 * (i % 13), 0.5 * i});
  tin.triangles.push_back({0, 1, 2});
  const SurfaceExtent extent = extent_of(tin);
  CHECK(extent.blocks.groups.size() == 2);
  check_groups(extent.blocks);
}

} // namespace orograph::extent_test
