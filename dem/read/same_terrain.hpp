// SPDX-License-Identifier: GPL-3.0-or-later
// Whether rasters speak of one terrain, and what they tell of it together.
#pragma once

#include "dem/read/raster_source.hpp"

#include <string>
#include <vector>

namespace orograph {

/// Throws Error, naming two of them, where several rasters aren't in one CRS, their heights are
/// above different things, or one doesn't tell its place. Adds a note where some tell what their
/// heights are above and others don't. Units of height may differ: heights are in metres.
void check_same_terrain(std::vector<RasterSource>& sources);

/// Each note once; with the files that it is about, where it isn't about all.
std::vector<std::string> notes_of(const std::vector<RasterSource>& sources);

} // namespace orograph
