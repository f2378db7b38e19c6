// SPDX-License-Identifier: GPL-3.0-or-later
// A raster's own heights at every second, fourth, eighth ... column and row, and how far triangles
// between them are from those that they leave out.
#pragma once

#include "dem/grid.hpp"
#include "dem/levels/departure.hpp"
#include "dem/levels/height_ranges.hpp"
#include "dem/levels/patch_heights.hpp"
#include "dem/levels/patches.hpp"

#include <cstddef>
#include <cstdint>
#include <variant>
#include <vector>

namespace orograph {

/// The finest level of which heights are kept: those of the one below would be a quarter of the
/// raster.
constexpr int kFinestKept = 2;

/// How many columns, or rows, a nested level has: those at whole cells from the first on.
constexpr int nested_places(int vertices, int level) {
  return ((vertices - 1) >> level) + 1;
}

/// Patches of a level along so many vertices.
constexpr int patches_along(int vertices, int level) {
  return (vertices - 2) / (kPatchCells << level) + 1;
}

/// So many heights' room all that is known of a raster of so many takes, at most: nested heights
/// are a sixteenth, and its share again; what is known of patches is less.
constexpr std::uint64_t nested_size(std::uint64_t heights) {
  return heights / 10;
}

/// Row-major.
using NestedHeights = std::variant<std::vector<float>, std::vector<double>>;

struct NestedCells {
  int columns = 0, rows = 0; ///< the raster's
  int coarsest = 0;          ///< level
  /// Of squares of kPatchCells of the raster's cells.
  std::vector<PartHeights> ranges;
  /// Of each patch, row-major, from level 1 on: of its triangles from all of the raster's heights
  /// in it and on its borders. Infinite where one of these is missing, and where it isn't of whole
  /// cells.
  std::vector<std::vector<Departure>> departures;
  std::vector<NestedHeights> heights; ///< from kFinestKept on

  const Departure& departure(int level, std::int64_t column, std::int64_t row) const {
    const auto across = static_cast<std::size_t>(patches_along(columns, level));
    return departures[static_cast<std::size_t>(level - 1)]
                     [static_cast<std::size_t>(row) * across + static_cast<std::size_t>(column)];
  }
  /// At a patch's vertices. REQUIRES a level from kFinestKept on, and whole cells.
  std::vector<double> heights_m(int level, const PatchHeights& lattice) const;
};

} // namespace orograph
