// SPDX-License-Identifier: GPL-3.0-or-later
// Heights where a raster has none.
#pragma once

#include "dem/grid.hpp"

#include <cstddef>

namespace orograph {

struct FilledVoids {
  std::size_t filled = 0, left = 0; ///< vertices
};

/// Fills missing heights from those around them, by inverse distance in eight directions, as GDAL
/// does (GDALFillNodata, without smoothing), no farther than `cells` from a height. Heights that
/// are there stay what they are. Throws Error where GDAL fails.
FilledVoids fill_voids(Grid& grid, double cells);

} // namespace orograph
