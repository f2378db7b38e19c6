// SPDX-License-Identifier: GPL-3.0-or-later
// The highest summits of a grid, and what became of them in a level of it.
#pragma once

#include "dem/grid.hpp"
#include "dem/levels/larger_cells.hpp"
#include "dem/levels/patches.hpp"
#include "dem/levels/patchwork.hpp"

#include <cstddef>
#include <vector>

namespace orograph {

/// Summits are as far apart, of the larger cells.
constexpr int kSummitsApart = 16;

struct Summit {
  Vec3 of_file_m; ///< in the ground frame, its true height
  Vec3 drawn_m;   ///< the highest vertex of the level within a cell of it
};

/// The `most` highest, from the highest on: each the highest ground within 16 of the larger cells.
/// REQUIRES a level that has the grid's corners. Cost: one look at each height.
std::vector<Summit> summits_of(const Grid& grid, const Grid& level, std::size_t most);
/// The same of a raster that was read in larger cells. `level` is these, or a level of them.
std::vector<Summit> summits_of(const LargerCells& file, const Grid& level);
/// The same of a patchwork, by the cells that it has there; each the highest ground within 16 of
/// the grid's.
std::vector<Summit> summits_of(const Grid& grid, const Patchwork& made, const Patches& patches,
                               std::size_t most);
/// The same of patches of a raster that was read in larger cells; `raster` is its lattice.
std::vector<Summit> summits_of(const LargerCells& file, const Grid& raster, const Patchwork& made,
                               const Patches& patches);

} // namespace orograph
