// SPDX-License-Identifier: GPL-3.0-or-later
// The extent of a grid on the ellipsoid.
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
#include <variant>
#include <vector>

namespace orograph {
namespace {

// On the ellipsoid so many blocks side by side: what is known of their columns, and of two rows of
// their vertices, stays in the processor's nearest cache.
constexpr int kEarthBlocksTogether = 4;
constexpr int kEarthColumns = kEarthBlocksTogether * kBlockSide;

// A row's vertices over some blocks, and the first one beyond them.
struct EarthPlaces {
  std::array<double, kEarthColumns + 1> x, y, z;
};

// A coordinate's bounds, a lane a column.
struct Lanes {
  std::array<double, kEarthColumns> low, high;
  Lanes() {
    low.fill(std::numeric_limits<double>::infinity());
    high.fill(-std::numeric_limits<double>::infinity());
  }
  // Of two rows.
  void take(const double* a, const double* b, int count) {
    for (int i = 0; i < count; ++i) {
      const double one_low = a[i] < low[i] ? a[i] : low[i],
                   one_high = a[i] > high[i] ? a[i] : high[i];
      low[i] = b[i] < one_low ? b[i] : one_low;
      high[i] = b[i] > one_high ? b[i] : one_high;
    }
  }
  double lowest(int first, int end) const { return *std::min_element(&low[first], &low[0] + end); }
  double highest(int first, int end) const {
    return *std::max_element(&high[first], &high[0] + end);
  }
};

// Of a block on the ellipsoid.
struct EarthBlock {
  Box3 box;
  double sum = 0;
  std::size_t count = 0;
};

// Of one block, whatever heights are missing; twice the work.
template <class Value>
EarthBlock earth_block_with_gaps(const Grid& grid, const Heights<Value>& heights,
                                 const Block& block) {
  EarthBlock out;
  std::array<double, kBlockSide> sum{};
  for (int row = block.row; row < block.row + block.rows; ++row)
    for (int i = 0; i < block.columns; ++i) {
      const double height = heights[grid.index(block.column + i, row)];
      if (std::isnan(height)) continue;
      const Vec3 at = grid.earth().vertex_m(block.column + i, row, height);
      out.box.include(at);
      sum[i] += at.z;
      ++out.count;
    }
  out.sum = std::accumulate(sum.begin(), sum.end(), 0.0);
  return out;
}

// Triangles between two rows of vertices that run clockwise in plan. Comparisons with NaN are
// false.
std::size_t turned_over(const EarthPlaces& north, const EarthPlaces& south, std::size_t cells) {
  std::size_t count = 0;
  for (std::size_t c = 0; c < cells; ++c) {
    const double across_x = south.x[c + 1] - north.x[c], across_y = south.y[c + 1] - north.y[c];
    const double lower =
        (south.x[c] - north.x[c]) * across_y - (south.y[c] - north.y[c]) * across_x;
    const double upper =
        across_x * (north.y[c + 1] - north.y[c]) - across_y * (north.x[c + 1] - north.x[c]);
    count += static_cast<std::size_t>((lower < 0) + (upper < 0));
  }
  return count;
}

// Of blocks side by side in one row; and how many triangles are turned over in the cells whose
// south-western vertex is one of theirs.
template <class Value>
std::size_t find_earth_blocks(const Grid& grid, const Heights<Value>& heights,
                              std::span<const Block> blocks, std::span<EarthBlock> out) {
  const Block& first = blocks.front();
  const int columns = blocks.back().column + blocks.back().columns - first.column,
            end = first.row + first.rows;
  const bool may_be_turned = !grid.earth().is_upright();
  const auto vertices = static_cast<std::size_t>(
      may_be_turned ? std::min(columns + 1, grid.columns - first.column) : columns);
  std::size_t turned = 0;
  std::array<EarthPlaces, 3> rows;
  EarthPlaces *north = &rows[0], *middle = &rows[1], *south = &rows[2];
  Lanes x, y, z;
  std::array<double, kEarthColumns> sum{};
  const auto place_row = [&](int row, EarthPlaces* of) {
    grid.earth().row_vertices_m(
        row, first.column, {&heights[grid.index(first.column, row)], vertices},
        {of->x.data(), vertices}, {of->y.data(), vertices}, {of->z.data(), vertices});
  };
  const auto add_turned = [&](const EarthPlaces* one, const EarthPlaces* other) {
    if (may_be_turned) turned += turned_over(*one, *other, vertices - 1);
  };
  if (may_be_turned && first.row > 0) place_row(first.row - 1, north);
  for (int row = first.row; row < end; row += 2) {
    place_row(row, middle);
    if (row > 0) add_turned(north, middle);
    const bool is_last = row + 1 == end;
    if (!is_last) {
      place_row(row + 1, south);
      add_turned(middle, south);
    }
    const EarthPlaces* const other = is_last ? middle : south;
    x.take(middle->x.data(), other->x.data(), columns);
    y.take(middle->y.data(), other->y.data(), columns);
    z.take(middle->z.data(), other->z.data(), columns);
    for (int i = 0; i < columns; ++i) sum[i] += middle->z[i];
    if (is_last) break;
    for (int i = 0; i < columns; ++i) sum[i] += south->z[i];
    std::swap(north, south);
  }
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const Block& block = blocks[i];
    const int from = block.column - first.column, to = from + block.columns;
    out[i] = {{{x.lowest(from, to), y.lowest(from, to), z.lowest(from, to)},
               {x.highest(from, to), y.highest(from, to), z.highest(from, to)}},
              std::accumulate(&sum[from], &sum[0] + to, 0.0),
              static_cast<std::size_t>(block.columns) * static_cast<std::size_t>(block.rows)};
    if (std::isnan(out[i].sum)) out[i] = earth_block_with_gaps(grid, heights, block);
  }
  return turned;
}

// On all cores, and added up in order.
template <class Value>
void find_blocks(const Grid& grid, const Heights<Value>& heights, BlocksFound& out) {
  const std::vector<Block> blocks = blocks_of(grid);
  const std::vector<BlockRange> ranges = side_by_side(blocks, kEarthBlocksTogether);
  std::vector<EarthBlock> found(blocks.size());
  std::vector<std::size_t> turned(ranges.size());
  constexpr std::size_t kRangesOfTask = 32;
  on_all_cores((ranges.size() + kRangesOfTask - 1) / kRangesOfTask, [&](std::size_t task) {
    const std::size_t end = std::min(ranges.size(), (task + 1) * kRangesOfTask);
    for (std::size_t i = task * kRangesOfTask; i < end; ++i) {
      throw_if_stopped();
      const auto [first, last] = ranges[i];
      turned[i] = find_earth_blocks(grid, heights, std::span(blocks).subspan(first, last - first),
                                    std::span(found).subspan(first, last - first));
    }
  });
  out.extent.turned_over = std::accumulate(turned.begin(), turned.end(), std::size_t{0});
  for (std::size_t i = 0; i < blocks.size(); ++i)
    if (found[i].count > 0) out.add(blocks[i], found[i].box, found[i].sum, found[i].count);
}

} // namespace

void find_blocks_on_earth(const Grid& grid, BlocksFound& out) {
  std::visit([&](const auto& heights) { find_blocks(grid, heights, out); }, grid.heights_m);
}

} // namespace orograph
