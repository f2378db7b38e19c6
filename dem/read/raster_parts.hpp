// SPDX-License-Identifier: GPL-3.0-or-later
// Parts of a raster that is otherwise read in larger cells.
#pragma once

#include "dem/levels/larger_cells.hpp"
#include "dem/read/read_options.hpp"

#include <string>
#include <vector>

namespace orograph {

/// These parts of rasters in their own cells. REQUIRES the paths and options of a terrain that was
/// read in larger cells, and parts of its raster's columns and rows. Throws Error where a file
/// can't be read (any more), and where the parts take more memory than the options allow. Cost:
/// that of reading the blocks in which the parts are.
std::vector<RasterPart> read_raster_parts(const std::vector<std::string>& paths,
                                          const ReadOptions& options,
                                          const std::vector<GridPart>& parts);

} // namespace orograph
