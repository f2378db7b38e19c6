// SPDX-License-Identifier: GPL-3.0-or-later
// The places in a text that GDAL reads as a raster, looked at before it reads the heights.
#pragma once

#include <string>

namespace orograph {

/// REQUIRES a text that GDAL's driver XYZ has opened: a line a place, in columns parted by blanks,
/// commas or semicolons, whose first line may name them. Throws Error where a place isn't finite:
/// the driver takes such a number for a column of the raster, and writes there (GDAL 3.6). Cost:
/// one pass over the text.
void check_xyz_places(const std::string& path);

} // namespace orograph
