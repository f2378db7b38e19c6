// SPDX-License-Identifier: GPL-3.0-or-later
// Lowest, highest and sum of a grid's heights, block by block.
//
// A lane for each column, because a single running minimum or sum has to be taken in order and
// therefore doesn't vectorize. Blocks side by side are looked at together: their rows are read on
// end, as memory likes it, and a block's sum is the same as it is alone.
#pragma once

#include "dem/grid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>

namespace orograph {

constexpr int kBlockSide = 32;        ///< in vertices
constexpr int kBlocksTogether = 8;    ///< at most, side by side
constexpr int kBlockRowsTogether = 4; ///< taken by a lane at once

struct Block {
  int column, row;   ///< of its first vertex
  int columns, rows; ///< less than kBlockSide at the grid's end
};

template <class Value>
struct BlockHeights {
  Value low = std::numeric_limits<Value>::infinity();
  Value high = -std::numeric_limits<Value>::infinity();
  double sum = 0;
  std::size_t count = 0; ///< of heights, not of NaN
};

/// `kLanes` columns.
template <int kLanes, class Value>
struct HeightLanes {
  std::array<Value, kLanes> low, high;
  std::array<double, kLanes> sum{};

  HeightLanes() {
    low.fill(std::numeric_limits<Value>::infinity());
    high.fill(-std::numeric_limits<Value>::infinity());
  }

  /// Some rows of vertices, from the first one's first. A NaN makes its lane's sum NaN, and
  /// comparisons with it are false.
  template <int kRows>
  void take(const Value* first, std::size_t to_next_row, int columns) {
    for (int i = 0; i < columns; ++i) {
      Value least = low[i], most = high[i];
      double all = sum[i];
      for (std::size_t row = 0; row < kRows; ++row) {
        const Value height = first[row * to_next_row + i];
        least = height < least ? height : least;
        most = height > most ? height : most;
        all += static_cast<double>(height);
      }
      low[i] = least;
      high[i] = most;
      sum[i] = all;
    }
  }

  /// Of a block's columns; where none of its heights is missing.
  BlockHeights<Value> of_block(int first, int columns, int rows) const {
    BlockHeights<Value> all;
    all.count = static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
    for (int i = first; i < first + columns; ++i) {
      all.low = std::min(all.low, low[i]);
      all.high = std::max(all.high, high[i]);
      all.sum += sum[i];
    }
    return all;
  }
};

/// Of one block, whatever heights are missing; three times the work.
template <class Value>
BlockHeights<Value> heights_with_gaps(const Grid& grid, const Heights<Value>& heights,
                                      const Block& block) {
  HeightLanes<kBlockSide, Value> lanes;
  std::array<int, kBlockSide> count{};
  for (int row = block.row; row < block.row + block.rows; ++row) {
    const Value* h = heights.data() + grid.index(block.column, row);
    for (int i = 0; i < block.columns; ++i) {
      const bool valid = !std::isnan(h[i]);
      lanes.low[i] = h[i] < lanes.low[i] ? h[i] : lanes.low[i];
      lanes.high[i] = h[i] > lanes.high[i] ? h[i] : lanes.high[i];
      lanes.sum[i] += static_cast<double>(valid ? h[i] : Value{0});
      count[i] += valid;
    }
  }
  BlockHeights<Value> all = lanes.of_block(0, block.columns, block.rows);
  all.count = 0;
  for (const int valid : count) all.count += static_cast<std::size_t>(valid);
  return all;
}

/// Of up to kBlocksTogether blocks side by side in one row, into `out`, one each.
template <class Value>
void heights_of_blocks(const Grid& grid, const Heights<Value>& heights,
                       std::span<const Block> blocks, std::span<BlockHeights<Value>> out) {
  const Block& first = blocks.front();
  const int columns = blocks.back().column + blocks.back().columns - first.column;
  const auto to_next_row = static_cast<std::size_t>(grid.columns);
  HeightLanes<kBlocksTogether * kBlockSide, Value> lanes;
  int row = 0;
  for (; row + kBlockRowsTogether <= first.rows; row += kBlockRowsTogether)
    lanes.template take<kBlockRowsTogether>(
        heights.data() + grid.index(first.column, first.row + row), to_next_row, columns);
  for (; row < first.rows; ++row)
    lanes.template take<1>(heights.data() + grid.index(first.column, first.row + row), to_next_row,
                           columns);
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const Block& block = blocks[i];
    out[i] = lanes.of_block(block.column - first.column, block.columns, block.rows);
    if (std::isnan(out[i].sum)) out[i] = heights_with_gaps(grid, heights, block);
  }
}

} // namespace orograph
