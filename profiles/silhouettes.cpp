// SPDX-License-Identifier: GPL-3.0-or-later
#include "profiles/silhouettes.hpp"

#include "profiles/earth_row_facing.hpp"
#include "profiles/plane_row_facing.hpp"

#include <cstdint>

namespace orograph {
namespace {

template <class RowFacing>
std::vector<SurfaceEdge> find(const Grid& grid, RowFacing facing) {
  const std::vector<std::uint8_t>&lower = facing.lower, &upper = facing.upper;
  const std::size_t cells = lower.size();
  std::vector<std::uint8_t> north_lower(cells, 0);
  std::vector<SurfaceEdge> edges;
  const auto add_if = [&](std::uint8_t a, std::uint8_t b, CellVertex from, CellVertex to,
                          CellVertex left, CellVertex right) {
    if (!are_seen_and_turned(a, b) || !facing.may_be_ridge(from, to, left, right)) return;
    edges.push_back({static_cast<std::uint32_t>(grid.index(from.column, from.row)),
                     static_cast<std::uint32_t>(grid.index(to.column, to.row))});
  };
  for (int row = 0; row + 1 < grid.rows; ++row) {
    facing.reckon(row);
    std::uint8_t west_upper = 0;
    for (std::size_t i = 0; i < cells; ++i) {
      // Where all that meet here face one way, as nearly everywhere, there is no silhouette.
      const auto together =
          static_cast<std::uint8_t>(lower[i] | upper[i] | north_lower[i] | west_upper);
      if (together == (kMayFace | kMayTurn)) {
        const int c = static_cast<int>(i), r = row;
        add_if(north_lower[i], upper[i], {c, r}, {c + 1, r}, {c, r - 1}, {c + 1, r + 1});
        add_if(west_upper, lower[i], {c, r}, {c, r + 1}, {c + 1, r + 1}, {c - 1, r});
        add_if(lower[i], upper[i], {c, r}, {c + 1, r + 1}, {c + 1, r}, {c, r + 1});
      }
      west_upper = upper[i];
    }
    north_lower = lower;
  }
  return edges;
}

} // namespace

std::vector<SurfaceEdge> silhouette_edges(const Grid& grid, const View& view) {
  return std::visit(
      [&](const auto& heights) {
        return grid.is_on_earth() ? find(grid, EarthRowFacing(grid, heights, view))
                                  : find(grid, PlaneRowFacing(grid, heights, view));
      },
      grid.heights_m);
}

} // namespace orograph
