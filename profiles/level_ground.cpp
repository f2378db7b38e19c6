// SPDX-License-Identifier: GPL-3.0-or-later
#include "profiles/level_ground.hpp"

#include "dem/tin.hpp"
#include "geometry/for_each_marked.hpp"
#include "geometry/on_all_cores.hpp"
#include "profiles/surface_edges.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

namespace orograph {
namespace {

// Triangles of a row of cells are numbered lower 0, upper 0, lower 1, … (2 * column + half), each a
// neighbour of the next. A run is a stretch of level ones; runs of neighbouring rows are joined
// where a lower triangle meets the upper one south of it, by union-find.

struct LevelRun {
  std::int32_t row, begin, end; ///< triangles [begin, end) of the row
};

class Sets {
public:
  explicit Sets(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), 0U);
  }
  std::uint32_t find(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::uint32_t a, std::uint32_t b) { parent_[find(a)] = find(b); }

private:
  std::vector<std::uint32_t> parent_;
};

// Marks the cells whose diagonal is level, without which neither triangle is; few of most ground.
// A loop for the vector units; NaN equals nothing.
template <class Height>
void mark_level_diagonals(const Height* __restrict north, const Height* __restrict south, int cells,
                          std::uint8_t* __restrict marks) {
  for (int c = 0; c < cells; ++c) marks[c] = north[c] == south[c + 1] ? 1 : 0;
}

// `marks`: for its memory, one a cell of a row.
template <class Height>
void append_runs(const Grid& grid, const Heights<Height>& heights, int row,
                 std::vector<std::uint8_t>& marks, std::vector<LevelRun>& runs) {
  const Height* north = &heights[grid.index(0, row)];
  const Height* south = &heights[grid.index(0, row + 1)];
  std::int32_t begin = -1;
  const auto take = [&](std::int32_t triangle, bool level) {
    if (level && begin < 0) begin = triangle;
    if (!level && begin >= 0) {
      runs.push_back({row, begin, triangle});
      begin = -1;
    }
  };
  const int cells = grid.columns - 1;
  mark_level_diagonals(north, south, cells, marks.data());
  int next = 0; // cell
  for_each_marked(marks, 0, cells, 1, [&](int c) {
    if (next < c) take(2 * next, false);
    take(2 * c, south[c] == north[c]);
    take(2 * c + 1, north[c + 1] == north[c]);
    next = c + 1;
  });
  take(2 * next, false);
}

// Of all rows, in order; found on all cores.
template <class Height>
std::vector<LevelRun> runs_of(const Grid& grid, const Heights<Height>& heights) {
  constexpr std::size_t kCellsOfTask = 1 << 14;
  const int rows = std::max(grid.rows - 1, 0);
  const int rows_of_task =
      static_cast<int>(kCellsOfTask / static_cast<std::size_t>(std::max(grid.columns, 1))) + 1;
  std::vector<std::vector<LevelRun>> of_tasks(
      static_cast<std::size_t>((rows + rows_of_task - 1) / rows_of_task));
  on_all_cores(of_tasks.size(), [&](std::size_t task) {
    const int first = static_cast<int>(task) * rows_of_task;
    std::vector<std::uint8_t> marks(static_cast<std::size_t>(grid.columns) - 1);
    for (int row = first; row < std::min(first + rows_of_task, rows); ++row)
      append_runs(grid, heights, row, marks, of_tasks[task]);
  });
  std::vector<LevelRun> runs;
  for (const std::vector<LevelRun>& some : of_tasks) {
    throw_if_stopped();
    runs.insert(runs.end(), some.begin(), some.end());
  }
  return runs;
}

// The first column at or after `triangle` whose triangle of this half is not before it.
std::int32_t column_from(std::int32_t triangle, Half half) {
  return half == Half::lower ? (triangle + 1) / 2 : triangle / 2;
}

void join_rows(const std::vector<LevelRun>& runs, std::size_t north, std::size_t south,
               std::size_t end, Sets& sets) {
  for (std::size_t i = north, k = south; i < south && k < end;) {
    const std::int32_t north_from = column_from(runs[i].begin, Half::lower);
    const std::int32_t north_to = column_from(runs[i].end, Half::lower);
    const std::int32_t south_from = column_from(runs[k].begin, Half::upper);
    const std::int32_t south_to = column_from(runs[k].end, Half::upper);
    if (std::max(north_from, south_from) < std::min(north_to, south_to))
      sets.join(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(k));
    if (north_to < south_to)
      ++i;
    else
      ++k;
  }
}

SurfaceEdge edge(const Grid& grid, int c0, int r0, int c1, int r1) {
  return {static_cast<std::uint32_t>(grid.index(c0, r0)),
          static_cast<std::uint32_t>(grid.index(c1, r1))};
}

template <class Height>
LevelGround find(const Grid& grid, const Heights<Height>& heights, std::size_t smallest) {
  const std::vector<LevelRun> runs = runs_of(grid, heights);
  Sets sets(runs.size());
  for (std::size_t north = 0, end = 0; end < runs.size();) {
    throw_if_stopped();
    const std::size_t south = end;
    while (end < runs.size() && runs[end].row == runs[south].row) ++end;
    if (runs[north].row + 1 == runs[south].row) join_rows(runs, north, south, end, sets);
    north = south;
  }

  std::vector<std::size_t> size(runs.size(), 0);
  for (std::size_t i = 0; i < runs.size(); ++i) {
    throw_if_stopped(i);
    size[sets.find(static_cast<std::uint32_t>(i))] +=
        static_cast<std::size_t>(runs[i].end - runs[i].begin);
  }
  LevelGround level;
  level.regions = static_cast<std::size_t>(
      std::count_if(size.begin(), size.end(), [&](std::size_t s) { return s >= smallest; }));
  if (level.regions == 0) return level;

  level.triangles = TriangleSet(grid_triangle_count(grid));
  const auto is_large = [&](std::size_t i) {
    return size[sets.find(static_cast<std::uint32_t>(i))] >= smallest;
  };
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (!is_large(i)) continue;
    throw_if_stopped();
    const std::size_t of_row = grid_triangle(grid, 0, runs[i].row, Half::lower);
    level.triangles.add_all(of_row + static_cast<std::size_t>(runs[i].begin),
                            of_row + static_cast<std::size_t>(runs[i].end));
  }

  // A shore has level ground on one side and, on the other, terrain that isn't.
  const auto land = [&](int column, int row, Half half) {
    if (column < 0 || row < 0 || column + 1 >= grid.columns || row + 1 >= grid.rows ||
        level.triangles.has(grid_triangle(grid, column, row, half)))
      return false;
    const Height corner = half == Half::lower ? heights[grid.index(column, row + 1)]
                                              : heights[grid.index(column + 1, row)];
    const Height sum =
        corner + heights[grid.index(column, row)] + heights[grid.index(column + 1, row + 1)];
    return !std::isnan(sum);
  };
  // Where a row beside a run, triangles [begin, end), has land on the other side of its edges.
  const auto for_each_column_of_land = [&](int row, Half half, std::int32_t begin, std::int32_t end,
                                           const auto& take) {
    if (row < 0 || row + 1 >= grid.rows) return;
    const Half of_run = half == Half::upper ? Half::lower : Half::upper;
    const std::size_t base = grid_triangle(grid, 0, row, half),
                      past = base + 2 * static_cast<std::size_t>(column_from(end, of_run));
    for (std::size_t t = base + 2 * static_cast<std::size_t>(column_from(begin, of_run));
         (t = level.triangles.first_missing_of_half(t, past)) < past; t += 2) {
      const int column = static_cast<int>((t - base) / 2);
      if (land(column, row, half)) take(column);
    }
  };
  const auto add_shore = [&](int c0, int r0, int c1, int r1) {
    level.shores.push_back(edge(grid, c0, r0, c1, r1));
  };
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (!is_large(i)) continue;
    throw_if_stopped();
    // Along the row a run's triangles have each other for neighbours, but for the first and last.
    const auto [row, begin, end] = runs[i];
    const int first = begin / 2, last = (end - 1) / 2;
    if (begin % 2 == 0) {
      if (land(first - 1, row, Half::upper)) add_shore(first, row, first, row + 1);
    } else if (land(first, row, Half::lower)) {
      add_shore(first, row, first + 1, row + 1);
    }
    if (end % 2 == 0) {
      if (land(last + 1, row, Half::lower)) add_shore(last + 1, row, last + 1, row + 1);
    } else if (land(last, row, Half::upper)) {
      add_shore(last, row, last + 1, row + 1);
    }
    for_each_column_of_land(row + 1, Half::upper, begin, end,
                            [&](int c) { add_shore(c, row + 1, c + 1, row + 1); });
    for_each_column_of_land(row - 1, Half::lower, begin, end,
                            [&](int c) { add_shore(c, row, c + 1, row); });
  }
  std::size_t steps = 0;
  std::sort(level.shores.begin(), level.shores.end(), StoppableLess(steps));
  return level;
}

} // namespace

LevelGround find_level_ground(const Grid& grid, std::size_t smallest) {
  return std::visit([&](const auto& heights) { return find(grid, heights, smallest); },
                    grid.heights_m);
}

std::size_t least_of_water(const Grid& grid) {
  return std::max<std::size_t>(500, 2 * grid.size() / 5000);
}

LevelGround find_water(const Grid& grid) {
  return find_level_ground(grid, least_of_water(grid));
}

namespace {

// A share of the TIN's ground: 45 mm² of an A4 map.
constexpr double kSmallestWater = 1e-3;

// `is_level(t)`: whether a triangle is.
template <class IsLevel>
LevelGround level_regions(const Tin& tin, double smallest_m2, const IsLevel& is_level) {
  LevelGround level;
  TriangleSet seen(tin.triangles.size());
  std::vector<std::uint32_t> region;
  for (std::uint32_t first = 0; first < tin.triangles.size(); ++first) {
    throw_if_stopped(first);
    if (seen.has(first) || !is_level(first)) continue;
    region.assign(1, first);
    seen.add(first);
    double area_m2 = 0;
    for (std::size_t i = 0; i < region.size(); ++i) {
      throw_if_stopped(i);
      area_m2 += plan_area_m2(tin, region[i]);
      for (const std::uint32_t other : tin.neighbours[region[i]])
        if (other != kNoTriangle && !seen.has(other) && is_level(other)) {
          seen.add(other);
          region.push_back(other);
        }
    }
    if (!(area_m2 >= smallest_m2)) continue;
    ++level.regions;
    if (level.triangles.empty()) level.triangles = TriangleSet(tin.triangles.size());
    for (const std::uint32_t t : region) level.triangles.add(t);
  }
  if (level.regions == 0) return level;
  for_each_edge(tin, [&](const TinEdge& e) {
    if (e.left != kNoTriangle && e.right != kNoTriangle &&
        level.triangles.has(e.left) != level.triangles.has(e.right))
      level.shores.push_back(e.edge);
  });
  std::size_t steps = 0;
  std::sort(level.shores.begin(), level.shores.end(), StoppableLess(steps));
  return level;
}

} // namespace

LevelGround find_level_ground(const Tin& tin, double smallest_m2) {
  return level_regions(tin, smallest_m2, [&](std::size_t t) {
    const auto& [a, b, c] = tin.triangles[t];
    return tin.vertices_m[a].z == tin.vertices_m[b].z && tin.vertices_m[b].z == tin.vertices_m[c].z;
  });
}

LevelGround find_level_ground(const Tin& tin, std::span<const double> heights_m,
                              double smallest_m2) {
  return level_regions(tin, smallest_m2, [&](std::size_t t) {
    const auto& [a, b, c] = tin.triangles[t];
    return heights_m[a] == heights_m[b] && heights_m[b] == heights_m[c];
  });
}

LevelGround find_water(const Tin& tin) {
  return find_level_ground(tin, kSmallestWater * plan_area_m2(tin));
}

namespace {

// Seen from above, what is left of an edge that runs east is north of it, of one that runs south
// east, of a diagonal north-east.
std::size_t triangle_at(const Grid& grid, const BorderEdge& border) {
  const auto columns = static_cast<std::uint32_t>(grid.columns);
  const auto [from, to] = border.edge;
  const auto column = static_cast<int>(from % columns), row = static_cast<int>(from / columns);
  const bool left = border.left;
  if (to == from + 1)
    return left ? grid_triangle(grid, column, row - 1, Half::lower)
                : grid_triangle(grid, column, row, Half::upper);
  if (to == from + columns)
    return left ? grid_triangle(grid, column, row, Half::lower)
                : grid_triangle(grid, column - 1, row, Half::upper);
  return grid_triangle(grid, column, row, left ? Half::upper : Half::lower);
}

std::vector<bool> borders_of(const Grid& grid, const std::vector<BorderEdge>& border,
                             const TriangleSet& triangles) {
  std::vector<bool> of_set(border.size());
  for (std::size_t i = 0; i < border.size(); ++i) {
    throw_if_stopped(i);
    of_set[i] = triangles.has(triangle_at(grid, border[i]));
  }
  return of_set;
}

std::vector<bool> borders_of(const Tin& tin, const std::vector<BorderEdge>& border,
                             const TriangleSet& triangles) {
  std::vector<bool> of_set(border.size());
  for_each_edge(tin, [&](const TinEdge& e) {
    if (e.left != kNoTriangle && e.right != kNoTriangle) return;
    if (!triangles.has(e.left != kNoTriangle ? e.left : e.right)) return;
    const auto at =
        std::lower_bound(border.begin(), border.end(), e.edge,
                         [](const BorderEdge& b, SurfaceEdge edge) { return b.edge < edge; });
    of_set[static_cast<std::size_t>(at - border.begin())] = true;
  });
  return of_set;
}

} // namespace

std::vector<bool> borders_of(const Surface& surface, const std::vector<BorderEdge>& border,
                             const TriangleSet& triangles) {
  return std::visit([&](const auto& s) { return borders_of(s, border, triangles); }, surface);
}

} // namespace orograph
