// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/levels/generalise.hpp"

#include "dem/levels/ground_around.hpp"
#include "dem/levels/level_windows.hpp"
#include "dem/levels/stretched_lattice.hpp"
#include "geometry/on_all_cores.hpp"

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace orograph {
namespace {

// The ground around each vertex, in rows of the level: of some of its columns and rows.
template <class Height>
std::vector<AroundRow> around_all(const Grid& grid, const Heights<Height>& heights,
                                  std::vector<LevelWindow> columns,
                                  const std::vector<LevelWindow>& rows) {
  std::vector<AroundRow> out(rows.size());
  // No other columns of the grid are gathered.
  const int first = columns.front().first, end = columns.back().last + 1;
  for (LevelWindow& window : columns) window = window.from(first);
  const auto line = [&](int row) {
    return std::span(heights.data() + grid.index(first, row),
                     static_cast<std::size_t>(end - first));
  };
  on_all_cores(rows.size(), [&](std::size_t j) {
    thread_local RowGathering<Height> gathering;
    gathering.begin(rows[j]);
    for (int row = rows[j].first; row <= rows[j].last; ++row) gathering.add(line(row), row);
    out[j] = gathering.around(line(rows[j].nearest()), columns);
  });
  return out;
}

// At a part of the vertices that have the windows.
template <class Height, class Is>
void generalise(const Grid& grid, const Heights<Height>& heights,
                const std::vector<LevelWindow>& across, const std::vector<LevelWindow>& down,
                const LevelPart& part, const Is& is_kept, std::vector<Height>& out) {
  const std::vector<AroundRow> around = around_all(grid, heights, across, down);
  out.resize(part.columns * part.rows);
  on_all_cores(part.rows, [&](std::size_t j) {
    const std::size_t row = part.first_row + j;
    const int nearest_row = down[row].nearest();
    const std::vector<double> made = heights_with_character(around, row);
    for (std::size_t i = 0; i < part.columns; ++i) {
      const std::size_t column = part.first_column + i;
      const int nearest = across[column].nearest();
      out[j * part.columns + i] = is_kept(nearest, nearest_row)
                                      ? heights[grid.index(nearest, nearest_row)]
                                      : static_cast<Height>(made[column]);
    }
  });
}

} // namespace

Grid generalised(const Grid& grid, int step, const std::function<bool(int, int)>& is_kept) {
  const int columns = vertices_for(grid.columns, step), rows = vertices_for(grid.rows, step);
  Grid out{columns, rows, stretched_lattice(grid, columns, rows), {}};
  std::visit(
      [&]<class Height>(const Heights<Height>& heights) {
        std::vector<Height> lower;
        generalise(grid, heights, stretched_windows(grid.columns, columns),
                   stretched_windows(grid.rows, rows),
                   {0, 0, static_cast<std::size_t>(columns), static_cast<std::size_t>(rows)},
                   is_kept, lower);
        out.heights_m = Heights<Height>(std::move(lower));
      },
      grid.heights_m);
  return out;
}

std::vector<double> heights_about(const Grid& grid, const LevelPlaces& places,
                                  const LevelPart& part,
                                  const std::function<bool(int, int)>& is_kept) {
  std::vector<double> out;
  std::visit(
      [&]<class Height>(const Heights<Height>& heights) {
        std::vector<Height> lower;
        generalise(grid, heights, windows_about(places.columns, places.step, grid.columns),
                   windows_about(places.rows, places.step, grid.rows), part, is_kept, lower);
        out.assign(lower.begin(), lower.end());
      },
      grid.heights_m);
  return out;
}

LevelPart whole_level(const Grid& grid, int step) {
  return {0, 0, static_cast<std::size_t>(nested_vertices(grid.columns, step)),
          static_cast<std::size_t>(nested_vertices(grid.rows, step))};
}

std::vector<double> nested_heights(const Grid& grid, int step, const LevelPart& part,
                                   const std::function<bool(int, int)>& is_kept) {
  const auto with_those_beside = [step](int vertices, std::size_t first, std::size_t count) {
    std::vector<double> places;
    const int end = std::min(static_cast<int>(first + count) + 1, nested_vertices(vertices, step));
    for (int i = std::max(0, static_cast<int>(first) - 1); i < end; ++i)
      places.push_back(std::min(i * step, vertices - 1));
    return places;
  };
  const LevelPlaces places{with_those_beside(grid.columns, part.first_column, part.columns),
                           with_those_beside(grid.rows, part.first_row, part.rows),
                           static_cast<double>(step)};
  return heights_about(grid, places,
                       {std::min<std::size_t>(part.first_column, 1),
                        std::min<std::size_t>(part.first_row, 1), part.columns, part.rows},
                       is_kept);
}

} // namespace orograph
