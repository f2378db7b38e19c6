// SPDX-License-Identifier: GPL-3.0-or-later
#include "profiles/silhouettes.hpp"

#include "geometry/on_all_cores.hpp"
#include "profiles/earth_row_facing.hpp"
#include "profiles/plane_row_facing.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace orograph {
namespace {

using CellRange = std::pair<int, int>; // columns of cells

// Of the rows of cells from `first` to `end`, in order.
template <class RowFacing>
void find(const Grid& grid, const SeenGround& ground, RowFacing& facing, int first, int end,
          std::vector<SurfaceEdge>& edges) {
  std::vector<std::uint8_t>&lower = facing.lower, &upper = facing.upper;
  const std::size_t cells = lower.size();
  // Cells that aren't looked at have no bits, and their edges are no silhouettes.
  std::vector<std::uint8_t> north_lower(cells, 0);
  std::vector<CellRange> ranges;
  int ranges_of = -1; // row of blocks
  const auto reckon = [&](int row) {
    if (row / SeenGround::kSide != ranges_of) {
      ranges_of = row / SeenGround::kSide;
      ground.cells_in_row(ranges_of, static_cast<int>(cells), ranges);
      std::fill(lower.begin(), lower.end(), std::uint8_t{0});
      std::fill(upper.begin(), upper.end(), std::uint8_t{0});
    }
    for (const auto& [begin, past] : ranges) facing.reckon(row, begin, past);
  };
  const auto add_if = [&](std::uint8_t a, std::uint8_t b, CellVertex from, CellVertex to,
                          CellVertex left, CellVertex right) {
    if (!are_seen_and_turned(a, b) || !facing.may_be_ridge(from, to, left, right)) return;
    edges.push_back({static_cast<std::uint32_t>(grid.index(from.column, from.row)),
                     static_cast<std::uint32_t>(grid.index(to.column, to.row))});
  };
  if (first > 0) {
    reckon(first - 1);
    north_lower = lower;
  }
  for (int row = first; row < end; ++row) {
    reckon(row);
    for (const auto& [begin, past] : ranges) {
      std::uint8_t west_upper = 0;
      for (int c = begin; c < past; ++c) {
        const auto i = static_cast<std::size_t>(c);
        // Where all that meet here face one way, as nearly everywhere, there is no silhouette.
        const auto together =
            static_cast<std::uint8_t>(lower[i] | upper[i] | north_lower[i] | west_upper);
        if (together == (kMayFace | kMayTurn)) {
          const int r = row;
          add_if(north_lower[i], upper[i], {c, r}, {c + 1, r}, {c, r - 1}, {c + 1, r + 1});
          add_if(west_upper, lower[i], {c, r}, {c, r + 1}, {c + 1, r + 1}, {c - 1, r});
          add_if(lower[i], upper[i], {c, r}, {c + 1, r + 1}, {c + 1, r}, {c, r + 1});
        }
        west_upper = upper[i];
      }
    }
    north_lower = lower;
  }
}

template <class MakeFacing>
std::vector<SurfaceEdge> find_on_all_cores(const Grid& grid, const SeenGround& ground,
                                           const MakeFacing& make_facing) {
  constexpr int kRowsOfTask = 64; // of which one is reckoned twice
  const int rows = grid.rows - 1;
  std::vector<std::vector<SurfaceEdge>> of_tasks(
      static_cast<std::size_t>((rows + kRowsOfTask - 1) / kRowsOfTask));
  on_all_cores(of_tasks.size(), [&](std::size_t task) {
    const int first = static_cast<int>(task) * kRowsOfTask;
    auto facing = make_facing();
    find(grid, ground, facing, first, std::min(first + kRowsOfTask, rows), of_tasks[task]);
  });
  std::size_t count = 0;
  for (const auto& some : of_tasks) count += some.size();
  std::vector<SurfaceEdge> edges;
  edges.reserve(count);
  for (const auto& some : of_tasks) edges.insert(edges.end(), some.begin(), some.end());
  return edges;
}

} // namespace

std::vector<SurfaceEdge> silhouette_edges(const Grid& grid, const View& view,
                                          const SeenGround* ground) {
  if (!ground) {
    const SeenGround all(grid);
    return silhouette_edges(grid, view, &all);
  }
  return std::visit(
      [&](const auto& heights) {
        return grid.is_on_earth()
                   ? find_on_all_cores(grid, *ground,
                                       [&] { return EarthRowFacing(grid, heights, view); })
                   : find_on_all_cores(grid, *ground,
                                       [&] { return PlaneRowFacing(grid, heights, view); });
      },
      grid.heights_m);
}

} // namespace orograph
