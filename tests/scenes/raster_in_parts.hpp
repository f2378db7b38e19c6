// SPDX-License-Identifier: GPL-3.0-or-later
// A grid in memory, as a raster too large for it is read.
#pragma once

#include "dem/levels/generalise.hpp"
#include "dem/levels/part_of_grid.hpp"
#include "dem/terrain.hpp"
#include "placing/placed_view.hpp"
#include "placing/terrain_of_view.hpp"
#include "tests/catch.hpp"

#include <algorithm>
#include <functional>
#include <utility>
#include <variant>
#include <vector>

namespace orograph {

/// `step` of its cells to one, and what is told of these.
inline TerrainData in_larger_cells(const TerrainData& file, int step) {
  const Grid& grid = std::get<Grid>(file.surface);
  TerrainData out = file;
  const Grid larger = generalised(grid, step, [](int, int) { return false; });
  out.larger_cells =
      LargerCells{step, grid.columns, grid.rows, departure_of(larger, grid), tops_of(grid, 16, 10)};
  out.surface = larger;
  out.surface_error_m += out.larger_cells->departure.greatest_m;
  return out;
}

/// The parts that a terrain in its frame misses for a placed view.
using MissingParts = std::function<std::vector<GridPart>(const TerrainData&, const PlacedView&)>;

/// What a view's patches, PatchesOfRaster or CertifiedRaster, look at of the grid's own cells.
inline void add_parts(TerrainData& whole, const Grid& file, const MapSpec& spec,
                      const MissingParts& missing_of) {
  const TerrainOfView terrain(whole, spec.view);
  const PlacedView placed = placed_picture(*terrain, facts_of(*terrain), spec, nullptr);
  TerrainData framed = *terrain;
  for (int round = 0;; ++round) {
    REQUIRE(round < 5);
    const auto missing = missing_of(framed, placed);
    if (missing.empty()) break;
    auto& parts = framed.larger_cells->parts;
    for (const GridPart& part : missing) parts.push_back({part, part_of_grid(file, part)});
    std::ranges::sort(parts, {}, [](const RasterPart& part) {
      return std::pair(part.at.first_row, part.at.first_column);
    });
  }
  whole.larger_cells->parts = framed.larger_cells->parts;
}

} // namespace orograph
