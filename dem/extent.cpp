// SPDX-License-Identifier: GPL-3.0-or-later
// The extent of a grid.
#include "dem/extent_blocks.hpp"
#include "geometry/on_all_cores.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

namespace orograph {
namespace {

// Lowest, highest and sum of a grid's heights, block by block.
//
// There is a lane for each column, because a single running minimum or sum has to be taken in order
// and therefore doesn't vectorize. Blocks side by side are looked at together: their rows are read
// on end, as memory likes it, and a block's sum is the same as it is alone.

constexpr int kBlocksTogether = 8;    ///< at most, side by side
constexpr int kBlockRowsTogether = 4; ///< taken by a lane at once

template <class Value>
struct BlockHeights {
  Value low = std::numeric_limits<Value>::infinity();
  Value high = -std::numeric_limits<Value>::infinity();
  double sum = 0;
  std::size_t count = 0; ///< of heights, not of NaN
};

// `kLanes` columns.
template <int kLanes, class Value>
struct HeightLanes {
  std::array<Value, kLanes> low, high;
  std::array<double, kLanes> sum{};

  HeightLanes() {
    low.fill(std::numeric_limits<Value>::infinity());
    high.fill(-std::numeric_limits<Value>::infinity());
  }

  // Some rows of vertices, from the first one's first. A NaN makes its lane's sum NaN, and
  // comparisons with it are false.
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

  // Of a block's columns; where none of its heights is missing.
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

// Of one block, whatever heights are missing; three times the work.
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

// Of up to kBlocksTogether blocks side by side in one row, into `out`, one each.
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

constexpr int group_side = 8; // in blocks
constexpr int tile_side = 8;  // in vertices

// Box of the valid vertices' positions. Positions are monotone in column and row, rounding
// included, so that the corners tell it where every vertex is valid.
template <class Value>
Box2 ground_box(const Grid& grid, const Heights<Value>& heights, const Block& block,
                bool all_valid) {
  const PlaneLattice& lattice = grid.plane();
  Box2 box;
  const int last_column = block.column + block.columns - 1, last_row = block.row + block.rows - 1;
  if (all_valid) {
    for (const int row : {block.row, last_row})
      for (const int column : {block.column, last_column})
        box.include(lattice.position_m(column, row));
    return box;
  }
  for (int row = block.row; row <= last_row; ++row)
    for (int column = block.column; column <= last_column; ++column)
      if (!std::isnan(heights[grid.index(column, row)]))
        box.include(lattice.position_m(column, row));
  return box;
}

// Squares of blocks, without those that have no block.
std::vector<BlockGroup> groups_of(const Grid& grid, const std::vector<Block>& blocks,
                                  const std::vector<Box3>& boxes) {
  constexpr int across = group_side * kBlockSide; // in vertices
  const int columns = (grid.columns + across - 1) / across,
            rows = (grid.rows + across - 1) / across;
  std::vector<BlockGroup> groups(static_cast<std::size_t>(columns) *
                                 static_cast<std::size_t>(rows));
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const auto [column, row] = std::pair(blocks[i].column / across, blocks[i].row / across);
    groups[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
           static_cast<std::size_t>(column)]
        .add(i, boxes[i]);
  }
  std::erase_if(groups, [](const BlockGroup& group) { return group.blocks.empty(); });
  return groups;
}

// In small squares one after the other, so that points which follow each other lie close together.
std::vector<Vec3> points_in(const Grid& grid, const Block& block, std::vector<Vec3> points) {
  points.clear();
  const int end_column = block.column + block.columns, end_row = block.row + block.rows;
  const auto take = [&](int first_column, int first_row) {
    std::visit(
        [&](const auto& lattice, const auto& heights) {
          for (int row = first_row; row < std::min(first_row + tile_side, end_row); ++row)
            for (int column = first_column; column < std::min(first_column + tile_side, end_column);
                 ++column) {
              const double height = heights[grid.index(column, row)];
              if (!std::isnan(height)) points.push_back(lattice.vertex_m(column, row, height));
            }
        },
        grid.lattice, grid.heights_m);
  };
  for (int row = block.row; row < end_row; row += tile_side)
    for (int column = block.column; column < end_column; column += tile_side) take(column, row);
  return points;
}

// The points of blocks, of which those asked for last are kept: a picture is framed from some sixty
// distances, and the same few blocks bound it from nearly all of them.
class PointsOfBlocks {
public:
  PointsOfBlocks(const Grid& grid, std::vector<Block> blocks)
      : grid_(grid), blocks_(std::move(blocks)) {}

  std::span<const Vec3> operator()(std::size_t block) {
    const auto kept = std::ranges::find(kept_, block, &Kept::block);
    if (kept != kept_.end()) return kept->points;
    Kept& oldest = kept_[next_];
    next_ = (next_ + 1) % kept_.size();
    oldest.block = block;
    oldest.points = points_in(grid_, blocks_[block], std::move(oldest.points));
    return oldest.points;
  }

private:
  struct Kept {
    std::size_t block = std::numeric_limits<std::size_t>::max();
    std::vector<Vec3> points;
  };
  const Grid& grid_;
  std::vector<Block> blocks_;
  std::array<Kept, 64> kept_;
  std::size_t next_ = 0;
};

template <class Value>
Box3 box_on_plane(const Grid& grid, const Heights<Value>& heights, const Block& block,
                  const BlockHeights<Value>& found) {
  const bool all_valid = found.count == static_cast<std::size_t>(block.columns) * block.rows;
  const Box2 ground = ground_box(grid, heights, block, all_valid);
  return {{ground.low.x, ground.low.y, found.low}, {ground.high.x, ground.high.y, found.high}};
}

// Looked at on all cores, added up in order: the mean is the same on any number of them.
template <class Value>
void find_on_plane(const Grid& grid, const Heights<Value>& heights, BlocksFound& out) {
  const std::vector<Block> blocks = blocks_of(grid);
  const std::vector<BlockRange> ranges = side_by_side(blocks, kBlocksTogether);
  std::vector<BlockHeights<Value>> found(blocks.size());
  std::vector<Box3> boxes(blocks.size());
  constexpr std::size_t kRangesOfTask = 32;
  on_all_cores((ranges.size() + kRangesOfTask - 1) / kRangesOfTask, [&](std::size_t task) {
    const std::size_t end = std::min(ranges.size(), (task + 1) * kRangesOfTask);
    for (std::size_t i = task * kRangesOfTask; i < end; ++i) {
      const auto [first, last] = ranges[i];
      heights_of_blocks(grid, heights, std::span(blocks).subspan(first, last - first),
                        std::span(found).subspan(first, last - first));
      for (std::size_t k = first; k < last; ++k)
        if (found[k].count > 0) boxes[k] = box_on_plane(grid, heights, blocks[k], found[k]);
    }
  });
  for (std::size_t i = 0; i < blocks.size(); ++i)
    if (found[i].count > 0) out.add(blocks[i], boxes[i], found[i].sum, found[i].count);
}

} // namespace

SurfaceExtent extent_of(const Grid& grid) {
  BlocksFound found;
  std::visit(
      [&](const auto& heights) {
        if (grid.is_on_earth())
          find_blocks_on_earth(grid, found);
        else
          find_on_plane(grid, heights, found);
      },
      grid.heights_m);
  SurfaceExtent& extent = found.extent;
  extent.mean_height_m = found.sum / static_cast<double>(extent.valid);
  extent.blocks.groups = groups_of(grid, found.occupied, extent.blocks.boxes);
  extent.blocks.points = PointsOfBlocks(grid, std::move(found.occupied));
  return std::move(extent);
}

} // namespace orograph
