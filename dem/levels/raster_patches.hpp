// SPDX-License-Identifier: GPL-3.0-or-later
// Patches of a raster that is in memory in larger cells, and in its own in some parts.
#pragma once

#include "dem/grid.hpp"
#include "dem/levels/larger_cells.hpp"
#include "dem/levels/patch_heights.hpp"
#include "dem/levels/patches.hpp"

#include <functional>
#include <vector>

namespace orograph {

/// The raster's lattice, without heights, in the frame of its larger cells.
Grid lattice_of_raster(const Grid& larger, const LargerCells& read);

/// The parts of the raster that patches of smaller cells than the larger ones look at, each once;
/// by rows, then by columns. Each is a square of 16 of the larger cells, and a cell more on all
/// sides. REQUIRES patches of the raster, none of smaller cells than its own.
std::vector<GridPart> parts_under(const LargerCells& read, const Patches& patches);

/// The same under patches whose heights `read.nested` hasn't.
std::vector<GridPart> parts_under_finest(const LargerCells& read, const Patches& patches);

/// The raster's own heights in a part of it, as float, where they were read; NaN elsewhere. In the
/// raster's frame. Cost: that of copying.
Grid own_cells_in(const GridPart& window, const Grid& raster, const LargerCells& read);

/// The raster's own heights at the vertices of patches of whole cells, as `certified_patches` makes
/// them: `patches_of_grid` of the raster, not generalised, gives the same. REQUIRES that what
/// `read.nested` has was read, and all `parts_under_finest` the patches, and that `read` outlives
/// it.
PatchSource nested_patches(const LargerCells& read);

/// Patches of cells that are smaller than the larger ones are what `patches_of_grid` makes of the
/// raster, but for what is level: there a vertex whose eight neighbours are as high keeps its
/// height. Others are made of the larger cells, of which they are as many times as large; where
/// these are kept, `is_kept` tells. Coarser ones than are shown have the heights that are there.
/// How far the latter are from the raster is a bound, and looked at where the larger cells'
/// vertices are. REQUIRES that all `parts_under` the patches were read, and that the arguments
/// outlive it.
PatchSource patches_of_raster(const Grid& larger, const LargerCells& read, const Patches& patches,
                              std::function<bool(int column, int row)> is_kept);

} // namespace orograph
