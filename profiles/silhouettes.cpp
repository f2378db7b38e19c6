// SPDX-License-Identifier: GPL-3.0-or-later
#include "profiles/silhouettes.hpp"

#include "geometry/for_each_marked.hpp"
#include "geometry/on_all_cores.hpp"
#include "profiles/earth_row_facing.hpp"
#include "profiles/facing.hpp"
#include "profiles/row_facing.hpp"
#include "profiles/surface_edges.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <utility>

namespace orograph {
namespace {

using CellRange = std::pair<int, int>; // columns of cells

// Marks the edges of a row's cells whose triangles face two ways: nearly nowhere. A loop without
// branches, for the vector units.
void mark_turns(const std::uint8_t* __restrict lower, const std::uint8_t* __restrict upper,
                const std::uint8_t* __restrict north_lower, int begin, int past,
                std::uint8_t* __restrict marks) {
  // `are_seen_and_turned`.
  const auto turns = [](std::uint8_t a, std::uint8_t b) {
    return static_cast<std::uint8_t>(((a & (b >> 1U)) | ((a >> 1U) & b)) & 1U);
  };
  static_assert(kMayFace == 1 && kMayTurn == 2);
  const auto mark = [&](int i, std::uint8_t west_upper) {
    return static_cast<std::uint8_t>(turns(north_lower[i], upper[i]) |
                                     turns(west_upper, lower[i]) << 1U |
                                     turns(lower[i], upper[i]) << 2U);
  };
  static_assert(SilhouetteMarks::kAlong == 1 && SilhouetteMarks::kUpright == 2 &&
                SilhouetteMarks::kDiagonal == 4);
  marks[begin] = mark(begin, 0);
  for (int i = begin + 1; i < past; ++i) marks[i] = mark(i, upper[i - 1]);
}

// Calls take(from, to) with the edges of the rows of cells from `first` to `end`, in order.
template <class RowFacing, class Take>
void find(const SeenGround& ground, RowFacing& facing, int first, int end, const Take& take) {
  std::vector<std::uint8_t>&lower = facing.lower, &upper = facing.upper;
  const std::size_t cells = lower.size();
  // Cells that aren't looked at have no bits, and their edges are no silhouettes.
  std::vector<std::uint8_t> north_lower(cells, 0);
  std::vector<std::uint8_t> marks(cells, 0);
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
  if (first > 0) {
    reckon(first - 1);
    north_lower = lower;
  }
  for (int row = first; row < end; ++row) {
    reckon(row);
    for (const auto& [begin, past] : ranges) {
      mark_turns(&lower[0], &upper[0], &north_lower[0], begin, past, &marks[0]);
      constexpr std::uint8_t kAny =
          SilhouetteMarks::kAlong | SilhouetteMarks::kUpright | SilhouetteMarks::kDiagonal;
      static_assert(kAny == (1U << kEdgesOfCell.size()) - 1);
      for_each_mark(marks, begin, past, kAny, [&](int column, std::uint8_t mark) {
        const auto edge = static_cast<std::size_t>(std::countr_zero(mark));
        if (!facing.may_be_ridge({column, row}, edge)) return;
        const CellVertex to = kEdgesOfCell[edge].to;
        take({column, row}, {column + to.column, row + to.row});
      });
    }
    north_lower = lower;
  }
}

// Calls with_facing(facing) with what tells a grid's rows.
template <class WithFacing>
void with_row_facing(const Grid& grid, const View& view, const WithFacing& with_facing) {
  std::visit(
      [&](const auto& heights) {
        if (grid.is_on_earth()) {
          EarthRowFacing facing(grid, heights, view);
          with_facing(facing);
        } else {
          PlaneRowFacing facing(grid, heights, view);
          with_facing(facing);
        }
      },
      grid.heights_m);
}

constexpr int kRowsOfTask = 64; // of which one is reckoned twice

// Calls take_of(task) on all cores, and what that returns with the task's edges, in order.
template <class TakeOf>
void find_on_all_cores(const Grid& grid, const View& view, const SeenGround* ground,
                       const TakeOf& take_of) {
  if (!ground) {
    const SeenGround all(grid);
    return find_on_all_cores(grid, view, &all, take_of);
  }
  const int rows = grid.rows - 1;
  on_all_cores(
      static_cast<std::size_t>((rows + kRowsOfTask - 1) / kRowsOfTask), [&](std::size_t task) {
        const int first = static_cast<int>(task) * kRowsOfTask,
                  end = std::min(first + kRowsOfTask, rows);
        with_row_facing(grid, view,
                        [&](auto& facing) { find(*ground, facing, first, end, take_of(task)); });
      });
}

std::vector<SurfaceEdge> joined(const std::vector<std::vector<SurfaceEdge>>& of_tasks) {
  std::size_t count = 0;
  for (const auto& some : of_tasks) count += some.size();
  std::vector<SurfaceEdge> edges;
  edges.reserve(count);
  for (const auto& some : of_tasks) {
    throw_if_stopped();
    edges.insert(edges.end(), some.begin(), some.end());
  }
  return edges;
}

} // namespace

std::vector<SurfaceEdge> silhouette_edges(const Grid& grid, const View& view,
                                          const SeenGround* ground) {
  std::vector<std::vector<SurfaceEdge>> of_tasks(
      static_cast<std::size_t>((grid.rows - 1 + kRowsOfTask - 1) / kRowsOfTask));
  find_on_all_cores(grid, view, ground, [&](std::size_t task) {
    return [&grid, &edges = of_tasks[task]](CellVertex from, CellVertex to) {
      edges.push_back({static_cast<std::uint32_t>(grid.index(from.column, from.row)),
                       static_cast<std::uint32_t>(grid.index(to.column, to.row))});
    };
  });
  return joined(of_tasks);
}

double silhouettes_a_cell(const Grid& grid, const View& view) {
  constexpr int kEvery = 32;
  const SeenGround all(grid);
  std::size_t count = 0, cells = 0;
  with_row_facing(grid, view, [&](auto& facing) {
    for (int row = 0; row < grid.rows - 1; row += kEvery) {
      find(all, facing, row, row + 1, [&](CellVertex, CellVertex) { ++count; });
      cells += static_cast<std::size_t>(grid.columns) - 1;
    }
  });
  return static_cast<double>(count) / static_cast<double>(cells);
}

SilhouetteMarks silhouette_marks(const Grid& grid, const View& view, bool rows_are_strips,
                                 const SeenGround* ground) {
  SilhouetteMarks out{rows_are_strips,
                      static_cast<std::size_t>(rows_are_strips ? grid.columns : grid.rows) - 1,
                      {}};
  out.marks.resize(static_cast<std::size_t>(grid.columns - 1) *
                   static_cast<std::size_t>(grid.rows - 1));
  find_on_all_cores(grid, view, ground, [&](std::size_t) {
    return [&out](CellVertex from, CellVertex to) {
      const bool rows = out.rows_are_strips;
      const auto strip = static_cast<std::size_t>(rows ? from.row : from.column),
                 cell = static_cast<std::size_t>(rows ? from.column : from.row);
      const bool along = rows ? to.row == from.row : to.column == from.column,
                 upright = rows ? to.column == from.column : to.row == from.row;
      out.marks[strip * out.cells + cell] |= along     ? SilhouetteMarks::kAlong
                                             : upright ? SilhouetteMarks::kUpright
                                                       : SilhouetteMarks::kDiagonal;
    };
  });
  return out;
}

std::vector<SurfaceEdge> silhouette_edges(const Tin& tin, const View& view) {
  const std::vector<std::uint8_t> facing = facing_of_triangles(tin, view);
  std::vector<std::vector<SurfaceEdge>> of_tasks(tasks_of_triangles(tin));
  on_all_cores(of_tasks.size(), [&](std::size_t task) {
    for_each_edge(tin, triangles_of_task(tin, task), [&](const TinEdge& e) {
      if (e.left == kNoTriangle || e.right == kNoTriangle ||
          !are_seen_and_turned(facing[e.left], facing[e.right]))
        return;
      const auto at = [&](std::uint32_t i) { return to_profile_frame(view, tin.vertices_m[i]); };
      if (may_be_ridge(at(e.edge.from), at(e.edge.to), at(apex_of(tin, e.left, e.edge)),
                       at(apex_of(tin, e.right, e.edge))))
        of_tasks[task].push_back(e.edge);
    });
  });
  std::vector<SurfaceEdge> edges = joined(of_tasks);
  std::size_t steps = 0;
  std::sort(edges.begin(), edges.end(), StoppableLess(steps));
  return edges;
}

std::vector<SurfaceEdge> silhouette_edges(const Surface& surface, const View& view,
                                          const SeenGround* ground) {
  if (const Tin* tin = std::get_if<Tin>(&surface)) return silhouette_edges(*tin, view);
  return silhouette_edges(std::get<Grid>(surface), view, ground);
}

} // namespace orograph
