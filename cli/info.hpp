// SPDX-License-Identifier: GPL-3.0-or-later
// `orograph info`: what a terrain is, for people.
#pragma once

#include "dem/read/read_options.hpp"
#include "dem/terrain.hpp"

#include <string>
#include <vector>

namespace orograph {

struct InfoSettings {
  std::vector<std::string> inputs; ///< as in RenderSettings
  ReadOptions reading;
  int jobs = 0; ///< as in RenderSettings
};

/// Aligned lines of "word   value": files, size, cells or triangles, CRS (and what heights are
/// above, where the file says it), units, bounds of the vertices in map coordinates, heights,
/// missing heights, memory, and the reader's notes. A few passes over the surface.
std::string describe(const TerrainData& terrain);

/// Reads the terrain and prints its description to standard output. Throws Error.
void info(const InfoSettings& settings);

} // namespace orograph
