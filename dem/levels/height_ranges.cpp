// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/levels/height_ranges.hpp"

#include "geometry/on_all_cores.hpp"

#include <algorithm>
#include <cmath>

namespace orograph {

void PartHeights::include(const PartHeights& other) {
  low_m = std::min(low_m, other.low_m);
  high_m = std::max(high_m, other.high_m);
}

HeightRanges::HeightRanges(const Grid& grid)
    : across_((grid.columns - 2) / kPatchCells + 1),
      tiles_(static_cast<std::size_t>(across_ * ((grid.rows - 2) / kPatchCells + 1))) {
  const auto across = static_cast<std::size_t>(across_);
  std::visit(
      [&](const auto& heights) {
        on_all_cores(tiles_.size() / across, [&](std::size_t of) {
          const int first = static_cast<int>(of) * kPatchCells;
          for (int row = first; row <= std::min(first + kPatchCells, grid.rows - 1); ++row)
            for (int column = 0; column < grid.columns; ++column) {
              const double height = heights[grid.index(column, row)];
              const auto take = [&](int tile) {
                PartHeights& range = tiles_[of * across + static_cast<std::size_t>(tile)];
                range.low_m = height < range.low_m ? height : range.low_m; // false for NaN
                range.high_m = height > range.high_m ? height : range.high_m;
              };
              take(std::min(column / kPatchCells, across_ - 1));
              if (column > 0 && column % kPatchCells == 0) take(column / kPatchCells - 1);
            }
        });
      },
      grid.heights_m);
}

PartHeights HeightRanges::of(const PatchPlace& part) const {
  const auto tile = [](double vertex) { return static_cast<int>(vertex) / kPatchCells; };
  PartHeights range;
  for (int row = tile(part.first_row); row < std::ceil(part.last_row / kPatchCells); ++row)
    for (int column = tile(part.first_column); column < std::ceil(part.last_column / kPatchCells);
         ++column)
      range.include(tiles_[static_cast<std::size_t>(row * across_ + column)]);
  return range;
}

} // namespace orograph
