// SPDX-License-Identifier: GPL-3.0-or-later
// `orograph index`: a raster's larger cells in a file beside it.
#pragma once

#include "dem/read/read_options.hpp"

#include <optional>
#include <string>
#include <vector>

namespace orograph {

struct IndexSettings {
  std::vector<std::string> inputs; ///< as in RenderSettings
  ReadOptions reading;
  int jobs = 0; ///< as in RenderSettings
  bool quiet = false;
  std::optional<bool> progress; ///< as in RenderSettings
};

/// Reads the rasters once and writes the index beside the first, in place of one that is there;
/// says on stderr what was made. Throws Error, also where another kind of file has its name.
void index(const IndexSettings& settings);

} // namespace orograph
