// SPDX-License-Identifier: GPL-3.0-or-later
// The square blocks of vertices by which a grid's extent is found, on a map plane or on the
// ellipsoid.
#pragma once

#include "dem/extent.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace orograph {

constexpr int kBlockSide = 32; ///< in vertices

struct Block {
  int column, row;   ///< of its first vertex
  int columns, rows; ///< less than kBlockSide at the grid's end
};

/// All of a grid, row after row.
inline std::vector<Block> blocks_of(const Grid& grid) {
  std::vector<Block> blocks;
  for (int row = 0; row < grid.rows; row += kBlockSide)
    for (int column = 0; column < grid.columns; column += kBlockSide)
      blocks.push_back({column, row, std::min(kBlockSide, grid.columns - column),
                        std::min(kBlockSide, grid.rows - row)});
  return blocks;
}

/// Blocks that are looked at together: side by side, [begin, end).
struct BlockRange {
  std::size_t begin, end;
};
inline std::vector<BlockRange> side_by_side(const std::vector<Block>& blocks, int together) {
  std::vector<BlockRange> ranges;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    if (blocks[i].column % (together * kBlockSide) == 0) ranges.push_back({i, i});
    ranges.back().end = i + 1;
  }
  return ranges;
}

/// What blocks a pass has found, and the sum of their heights.
struct BlocksFound {
  SurfaceExtent extent;
  std::vector<Block> occupied;
  double sum = 0;

  void add(const Block& block, const Box3& box, double block_sum, std::size_t count) {
    occupied.push_back(block);
    extent.blocks.boxes.push_back(box);
    extent.box.include(box.low);
    extent.box.include(box.high);
    sum += block_sum;
    extent.valid += count;
  }
};

/// REQUIRES a grid on the ellipsoid. Cost: 5 ns a vertex, and half as much again where the lattice
/// isn't known to be upright.
void find_blocks_on_earth(const Grid& grid, BlocksFound& out);

} // namespace orograph
