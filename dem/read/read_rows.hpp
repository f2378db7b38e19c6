// SPDX-License-Identifier: GPL-3.0-or-later
// Heights of some rows of a terrain of rasters.
#pragma once

#include "dem/levels/part_of_grid.hpp"
#include "dem/read/open_rasters.hpp"
#include "dem/read/raster_heights.hpp"
#include "dem/read/read_options.hpp"

namespace orograph {

/// Rows of a grid: from the first, so many.
struct RowRange {
  int first = 0, rows = 0;
};

/// Rows of the set's grid, from the parts of the files that lie in them; NaN where none does. Adds
/// what GDAL warns of to the sources' notes. Throws Error where a file can't be read.
ReadHeights read_rows(RasterSet& set, const RowRange& range, const ReadOptions& options,
                      HeightDifferences& differences);
/// The same of a part of its columns, too. Where many parts are read one after the other blocks
/// are kept in GDAL's cache.
ReadHeights read_part_of_rows(RasterSet& set, const GridPart& part, const ReadOptions& options,
                              HeightDifferences& differences);

/// Leaves the heights in the box that was asked for: of a rotated or sheared raster the window
/// holds more. They are those of a part of the set's grid.
void leave_in_box(const RasterSet& set, const GridPart& part, ReadHeights& heights);
void leave_in_box(const RasterSet& set, Grid& grid);

} // namespace orograph
