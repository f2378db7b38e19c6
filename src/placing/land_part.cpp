// SPDX-License-Identifier: GPL-3.0-or-later
#include "placing/land_part.hpp"

#include "geometry/on_all_cores.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <vector>

namespace orograph {
namespace {

// A part is worth it where it is smaller than this.
constexpr double kLargestShare = 0.9;
// Water about the land, of its longer side: what is left of a sea has to count as water.
constexpr double kStrip = 0.02;
constexpr int kLeastStrip = 2; // cells

constexpr std::array<std::string_view, 5> kOverAllTerrain{"block", "mesh", "graticule", "grid",
                                                          "drape"};

bool shows_land_alone(const MapSpec& spec) {
  const Style& style = spec.style;
  return style.flat != FlatGround::draw && style.outline == Outline::one &&
         style.underside == Underside::omit && !style.draws_waterlines() && !spec.view.has_eye() &&
         !spec.view.file && std::ranges::none_of(kOverAllTerrain, [&](std::string_view name) {
           return style.asks_for(name);
         });
}

// Of a row of cells the first and the last with land, or the first greater than the last.
struct Columns {
  int first, last;
};

Columns land_in_row(const Grid& grid, const TriangleSet& water, int row) {
  const auto is_land = [&](int column) {
    for (const Half half : {Half::lower, Half::upper}) {
      if (water.has(grid_triangle(grid, column, row, half))) continue;
      const int third_column = half == Half::upper ? column + 1 : column,
                third_row = half == Half::upper ? row : row + 1;
      if (!std::isnan(grid.height_m(column, row)) &&
          !std::isnan(grid.height_m(column + 1, row + 1)) &&
          !std::isnan(grid.height_m(third_column, third_row)))
        return true;
    }
    return false;
  };
  Columns land{0, grid.columns - 2};
  while (land.first <= land.last && !is_land(land.first)) ++land.first;
  while (land.first <= land.last && !is_land(land.last)) --land.last;
  return land;
}

} // namespace

std::optional<GridPart> land_part(const Grid& grid, const TriangleSet& water, const MapSpec& spec) {
  if (water.empty() || grid.columns < 2 || grid.rows < 2 || !shows_land_alone(spec))
    return std::nullopt;
  std::vector<Columns> rows(static_cast<std::size_t>(grid.rows) - 1);
  on_all_cores(rows.size(), [&](std::size_t row) {
    rows[row] = land_in_row(grid, water, static_cast<int>(row));
  });
  int left = grid.columns, right = -1, top = grid.rows, bottom = -1; // cells
  for (int row = 0; row + 1 < grid.rows; ++row) {
    const auto [first, last] = rows[static_cast<std::size_t>(row)];
    if (first > last) continue;
    left = std::min(left, first);
    right = std::max(right, last);
    top = std::min(top, row);
    bottom = row;
  }
  if (right < left) return std::nullopt; // all of it is water
  const int strip = std::max(
      kLeastStrip, static_cast<int>(std::ceil(kStrip * std::max(right - left, bottom - top))));
  left = std::max(left - strip, 0);
  top = std::max(top - strip, 0);
  right = std::min(right + strip, grid.columns - 2);
  bottom = std::min(bottom + strip, grid.rows - 2);
  const GridPart part{left, top, right - left + 2, bottom - top + 2};
  const double share =
      static_cast<double>(part.columns) * part.rows / static_cast<double>(grid.size());
  if (share > kLargestShare) return std::nullopt;
  return part;
}

} // namespace orograph
