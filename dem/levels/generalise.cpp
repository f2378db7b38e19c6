// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/levels/generalise.hpp"

#include "dem/levels/ground_around.hpp"
#include "dem/levels/level_windows.hpp"
#include "dem/levels/stretched_lattice.hpp"
#include "geometry/on_all_cores.hpp"

#include <span>
#include <utility>
#include <vector>

namespace orograph {
namespace {

// The ground around each vertex, in rows of the level.
template <class Height>
std::vector<AroundRow> around_all(const Grid& grid, const Heights<Height>& heights,
                                  const std::vector<LevelWindow>& columns,
                                  const std::vector<LevelWindow>& rows) {
  std::vector<AroundRow> out(rows.size());
  const auto line = [&](int row) {
    return std::span(heights.data() + grid.index(0, row), static_cast<std::size_t>(grid.columns));
  };
  on_all_cores(rows.size(), [&](std::size_t j) {
    thread_local RowGathering gathering;
    gathering.begin(rows[j]);
    for (int row = rows[j].first; row <= rows[j].last; ++row) gathering.add(line(row), row);
    out[j] = gathering.around(line(rows[j].nearest()), columns);
  });
  return out;
}

template <class Height, class Is>
void generalise(const Grid& grid, const Heights<Height>& heights,
                const std::vector<LevelWindow>& across, const std::vector<LevelWindow>& down,
                const Is& is_kept, std::vector<Height>& out) {
  const std::vector<AroundRow> around = around_all(grid, heights, across, down);
  out.resize(across.size() * down.size());
  on_all_cores(down.size(), [&](std::size_t j) {
    const int nearest_row = down[j].nearest();
    for (std::size_t i = 0; i < across.size(); ++i) {
      const int nearest = across[i].nearest();
      out[j * across.size() + i] = is_kept(nearest, nearest_row)
                                       ? heights[grid.index(nearest, nearest_row)]
                                       : static_cast<Height>(height_with_character(
                                             around, static_cast<int>(i), static_cast<int>(j)));
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
                   stretched_windows(grid.rows, rows), is_kept, lower);
        out.heights_m = Heights<Height>(std::move(lower));
      },
      grid.heights_m);
  return out;
}

NestedHeights nested_heights(const Grid& grid, int step,
                             const std::function<bool(int, int)>& is_kept) {
  NestedHeights out;
  const std::vector<LevelWindow> across = nested_windows(grid.columns, step);
  out.columns = across.size();
  std::visit(
      [&]<class Height>(const Heights<Height>& heights) {
        std::vector<Height> lower;
        generalise(grid, heights, across, nested_windows(grid.rows, step), is_kept, lower);
        out.heights_m.assign(lower.begin(), lower.end());
      },
      grid.heights_m);
  return out;
}

} // namespace orograph
