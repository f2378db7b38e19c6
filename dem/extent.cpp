// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/extent.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

namespace orograph {
namespace {

constexpr int side = 32; // of a block, in vertices

struct Block {
  int column, row;   // of its first vertex
  int columns, rows; // less than `side` at the grid's end
};

template <class Value>
struct Heights {
  Value low = std::numeric_limits<Value>::infinity();
  Value high = -std::numeric_limits<Value>::infinity();
  double sum = 0;
  std::size_t count = 0;
};

// A lane for each column, because a single running minimum or sum has to be taken in order and
// therefore doesn't vectorize. Comparisons with NaN are false.
template <class Value>
Heights<Value> heights_in(const Grid& grid, const std::vector<Value>& heights, const Block& block) {
  std::array<Value, side> low, high;
  std::array<double, side> sum{};
  std::array<int, side> count{};
  low.fill(std::numeric_limits<Value>::infinity());
  high.fill(-std::numeric_limits<Value>::infinity());
  for (int row = block.row; row < block.row + block.rows; ++row) {
    const Value* h = heights.data() + grid.index(block.column, row);
    for (int i = 0; i < block.columns; ++i) {
      const bool valid = !std::isnan(h[i]);
      low[i] = h[i] < low[i] ? h[i] : low[i];
      high[i] = h[i] > high[i] ? h[i] : high[i];
      sum[i] += static_cast<double>(valid ? h[i] : Value{0});
      count[i] += valid;
    }
  }
  Heights<Value> all;
  for (int i = 0; i < block.columns; ++i) {
    all.low = std::min(all.low, low[i]);
    all.high = std::max(all.high, high[i]);
    all.sum += sum[i];
    all.count += static_cast<std::size_t>(count[i]);
  }
  return all;
}

// Box of the valid vertices' positions. Positions are monotone in column and row, rounding
// included, so that the corners tell it where every vertex is valid.
template <class Value>
Box2 ground_box(const Grid& grid, const std::vector<Value>& heights, const Block& block,
                bool all_valid) {
  Box2 box;
  const int last_column = block.column + block.columns - 1, last_row = block.row + block.rows - 1;
  if (all_valid) {
    for (const int row : {block.row, last_row})
      for (const int column : {block.column, last_column})
        box.include(grid.position_m(column, row));
    return box;
  }
  for (int row = block.row; row <= last_row; ++row)
    for (int column = block.column; column <= last_column; ++column)
      if (!std::isnan(heights[grid.index(column, row)])) box.include(grid.position_m(column, row));
  return box;
}

std::vector<Block> blocks_of(const Grid& grid) {
  std::vector<Block> blocks;
  for (int row = 0; row < grid.rows; row += side)
    for (int column = 0; column < grid.columns; column += side)
      blocks.push_back(
          {column, row, std::min(side, grid.columns - column), std::min(side, grid.rows - row)});
  return blocks;
}

std::vector<Vec3> points_in(const Grid& grid, const Block& block, std::vector<Vec3> points) {
  points.clear();
  std::visit(
      [&](const auto& heights) {
        for (int row = block.row; row < block.row + block.rows; ++row)
          for (int column = block.column; column < block.column + block.columns; ++column) {
            const double height = heights[grid.index(column, row)];
            if (std::isnan(height)) continue;
            const Vec2 at = grid.position_m(column, row);
            points.push_back({at.x, at.y, height});
          }
      },
      grid.heights_m);
  return points;
}

} // namespace

SurfaceExtent extent_of(const Grid& grid) {
  SurfaceExtent extent;
  std::vector<Block> occupied;
  double sum = 0;
  std::visit(
      [&](const auto& heights) {
        for (const Block& block : blocks_of(grid)) {
          const auto found = heights_in(grid, heights, block);
          if (found.count == 0) continue;
          const bool all_valid =
              found.count == static_cast<std::size_t>(block.columns) * block.rows;
          const Box2 ground = ground_box(grid, heights, block, all_valid);
          occupied.push_back(block);
          extent.blocks.boxes.push_back({{ground.low.x, ground.low.y, found.low},
                                         {ground.high.x, ground.high.y, found.high}});
          extent.box.include(extent.blocks.boxes.back().low);
          extent.box.include(extent.blocks.boxes.back().high);
          sum += found.sum;
          extent.valid += found.count;
        }
      },
      grid.heights_m);
  extent.mean_height_m = sum / static_cast<double>(extent.valid);
  extent.blocks.points = [&grid, occupied = std::move(occupied),
                          buffer = std::vector<Vec3>()](std::size_t i) mutable {
    buffer = points_in(grid, occupied[i], std::move(buffer));
    return std::span<const Vec3>(buffer);
  };
  return extent;
}

} // namespace orograph
