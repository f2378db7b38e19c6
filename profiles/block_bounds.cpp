// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/on_all_cores.hpp"
#include "profiles/seen_ground.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <span>
#include <variant>
#include <vector>

namespace orograph {
namespace {

constexpr int kSide = SeenGround::kSide;

// Of a row of blocks of a grid on a map plane.
template <class Height>
void greatest_heights(const Grid& grid, const Heights<Height>& heights, int block_row,
                      std::vector<Height>& lanes, double* out) {
  const int first = block_row * kSide, last = std::min(first + kSide, grid.rows - 1);
  lanes.assign(static_cast<std::size_t>(grid.columns), -std::numeric_limits<Height>::infinity());
  for (int row = first; row <= last; ++row) {
    const Height* const h = &heights[grid.index(0, row)];
    Height* const lane = lanes.data();
    for (int c = 0; c < grid.columns; ++c) lane[c] = h[c] > lane[c] ? h[c] : lane[c];
  }
  for (int c = 0; c < grid.columns - 1; c += kSide)
    *out++ = *std::max_element(lanes.begin() + c,
                               lanes.begin() + std::min(c + kSide, grid.columns - 1) + 1);
}

// Lowest and highest of some coordinate, a value a column.
struct Lanes {
  std::vector<double> low, high;

  void clear(std::size_t count) {
    low.assign(count, kInfinity);
    high.assign(count, -kInfinity);
  }
  void include(const std::vector<double>& values) {
    const double* const v = values.data();
    double *const l = low.data(), *const h = high.data();
    // What isn't there is NaN, and neither less nor greater.
    for (std::size_t i = 0; i < low.size(); ++i) {
      l[i] = v[i] < l[i] ? v[i] : l[i];
      h[i] = v[i] > h[i] ? v[i] : h[i];
    }
  }
};

// The same of a grid on the ellipsoid.
template <class Height>
void boxes_of_row(const Grid& grid, const Heights<Height>& heights, int block_row, Box3* out) {
  const auto count = static_cast<std::size_t>(grid.columns);
  std::array<std::vector<double>, 3> places;
  std::array<Lanes, 3> lanes;
  for (std::size_t k = 0; k < 3; ++k) {
    places[k].resize(count);
    lanes[k].clear(count);
  }
  const int first = block_row * kSide, last = std::min(first + kSide, grid.rows - 1);
  for (int row = first; row <= last; ++row) {
    grid.earth().row_vertices_m(row, 0, std::span(&heights[grid.index(0, row)], count), places[0],
                                places[1], places[2]);
    for (std::size_t k = 0; k < 3; ++k) lanes[k].include(places[k]);
  }
  for (int c = 0; c < grid.columns - 1; c += kSide, ++out)
    for (int i = c; i <= std::min(c + kSide, grid.columns - 1); ++i) {
      const auto at = static_cast<std::size_t>(i);
      if (!(lanes[0].low[at] <= lanes[0].high[at])) continue;
      out->include({lanes[0].low[at], lanes[1].low[at], lanes[2].low[at]});
      out->include({lanes[0].high[at], lanes[1].high[at], lanes[2].high[at]});
    }
}

// Of groups of blocks, in so many rows.
BoundsOfBlocks groups_of(const BoundsOfBlocks& blocks, int rows) {
  constexpr int kGroup = BlockBounds::kGroup;
  BoundsOfBlocks out;
  out.columns = (blocks.columns + kGroup - 1) / kGroup;
  const auto count = static_cast<std::size_t>(out.columns) *
                     static_cast<std::size_t>((rows + kGroup - 1) / kGroup);
  if (blocks.boxes_m.empty())
    out.heights.assign(count, -kInfinity);
  else
    out.boxes_m.resize(count);
  const auto across = static_cast<std::size_t>(blocks.columns);
  for (std::size_t i = 0; i < blocks.count(); ++i) {
    const std::size_t group =
        i / across / kGroup * static_cast<std::size_t>(out.columns) + i % across / kGroup;
    if (blocks.boxes_m.empty()) {
      out.heights[group] = std::max(out.heights[group], blocks.heights[i]);
    } else if (const Box3& box = blocks.boxes_m[i]; !box.empty()) {
      out.boxes_m[group].include(box.low);
      out.boxes_m[group].include(box.high);
    }
  }
  return out;
}

} // namespace

BlockBounds block_bounds(const Grid& grid) {
  const int rows = SeenGround::blocks_in(grid.rows - 1);
  BlockBounds out;
  BoundsOfBlocks& blocks = out.blocks;
  blocks.columns = SeenGround::blocks_in(grid.columns - 1);
  const auto across = static_cast<std::size_t>(blocks.columns),
             down = static_cast<std::size_t>(rows);
  const bool on_earth = grid.is_on_earth();
  if (on_earth)
    blocks.boxes_m.resize(across * down);
  else
    blocks.heights.resize(across * down);
  on_all_cores(down, [&](std::size_t row) {
    std::visit(
        [&]<class Height>(const Heights<Height>& heights) {
          if (on_earth) {
            boxes_of_row(grid, heights, static_cast<int>(row), &blocks.boxes_m[row * across]);
          } else {
            std::vector<Height> lanes;
            greatest_heights(grid, heights, static_cast<int>(row), lanes,
                             &blocks.heights[row * across]);
          }
        },
        grid.heights_m);
  });
  out.groups = groups_of(blocks, rows);
  return out;
}

} // namespace orograph
